// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include "drawing/scale_numbers.h"
#include "report/scene.h"

namespace mikromakro {
namespace {

using Quantisers = std::vector<std::optional<Quantiser>>;

Quantisers quantisers(std::span<const SceneColumn> columns, const std::vector<Limits>& limits) {
  Quantisers all(columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (!limits[i].empty()) all[i].emplace(limits[i], columns[i].bits, columns[i].whole);
  return all;
}

void add_to(std::vector<Limits>& limits, const std::vector<std::vector<double>>& columns) {
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (const double number : columns[i])
      if (!std::isnan(number)) limits[i].add(number);
}

// Without a thickness, pressures are per length.
std::string unit_of(std::string_view unit, const SceneOptions& options) {
  return unit == "Pa" && !(options.height > 0) ? "N/m" : std::string(unit);
}

Json columns_json(std::span<const SceneColumn> columns, const Quantisers& quantisers,
                  const SceneOptions& options) {
  Json list = Json::array();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (!quantisers[i]) continue;
    list.push_back({{"name", columns[i].name},
                    {"unit", unit_of(columns[i].unit, options)},
                    {"low", quantisers[i]->low()},
                    {"step", quantisers[i]->step()},
                    {"unknown", quantisers[i]->unknown()}});
  }
  return list;
}

PictureStyle style_of(std::string_view quantity, const SceneOptions& options) {
  PictureStyle style;
  style.quantity = &disc_quantity(std::string(quantity));
  style.bulk_types = options.bulk_types;
  style.height = options.height > 0 ? options.height : 1;
  return style;
}

}  // namespace

SceneRanges::SceneRanges(SceneOptions options)
    : options_(std::move(options)),
      discs_(disc_scene_columns().size()),
      contacts_(contact_scene_columns().size()),
      scales_(disc_quantity_names().size()) {}

void SceneRanges::add(const Frame& frame) {
  const SceneFrame scene = scene_frame(frame, options_.height > 0 ? options_.height : 1);
  add_to(discs_, scene.discs);
  add_to(contacts_, scene.contacts);
  const std::vector<std::string_view> names = disc_quantity_names();
  for (std::size_t i = 0; i < names.size(); ++i) scales_[i].add(frame, style_of(names[i], options_));
  for (const Particle& disc : frame.particles)
    radii_ += (disc.radius - radii_) / static_cast<double>(++count_);
}

Quantisers SceneRanges::disc_quantisers() const {
  return quantisers(disc_scene_columns(), discs_);
}

Quantisers SceneRanges::contact_quantisers() const {
  return quantisers(contact_scene_columns(), contacts_);
}

// Those that the input has; numbers of contacts where it has contacts.
Json SceneRanges::quantities() const {
  Json list = Json::array();
  const std::vector<std::string_view> names = disc_quantity_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string name(names[i]);
    const QuantityInfo& info = disc_quantity(name);
    const Limits& limits = scales_[i].colours;
    const bool of_contacts = info.contacts_needed != 0;
    if (limits.empty() || !std::isfinite(scales_[i].values.low + scales_[i].values.high) ||
        (of_contacts && scales_[i].contacts == 0))
      continue;
    list.push_back({{"name", info.name},
                    {"label", info.label},
                    {"unit", unit_of(info.unit, options_)},
                    {"low", limits.low},
                    {"high", limits.high}});
  }
  return list;
}

Json SceneRanges::description() const {
  const PictureScales& scales = scales_.front();
  const Box window = scales.window.value_or(Box{});
  return {{"window", {window.low.x(), window.high.x(), window.low.y(), window.high.y()}},
          {"mean_radius", radii_},
          {"mean_force", scales.mean_force},
          {"bulk_types", options_.bulk_types},
          {"disc_columns", columns_json(disc_scene_columns(), disc_quantisers(), options_)},
          {"contact_columns", columns_json(contact_scene_columns(), contact_quantisers(), options_)},
          {"quantities", quantities()}};
}

}  // namespace mikromakro
