// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include "report/scene.h"

namespace mikromakro {
namespace {

using Codes = std::vector<std::uint16_t>;

Codes codes_of(const std::vector<double>& numbers, const Quantiser& quantiser) {
  Codes codes;
  codes.reserve(numbers.size());
  for (const double number : numbers) codes.push_back(quantiser.code(number));
  return codes;
}

// Small differences of both signs become small numbers.
Codes differences(const Codes& codes, const Codes& before) {
  Codes folded(codes.size());
  for (std::size_t i = 0; i < codes.size(); ++i) {
    const auto difference = static_cast<std::int16_t>(codes[i] - before[i]);
    folded[i] = static_cast<std::uint16_t>(difference < 0 ? -2 * difference - 1 : 2 * difference);
  }
  return folded;
}

// The 16-bit numbers that make up longer ones, the lowest first.
template <typename Number>
void append_words(const std::vector<Number>& numbers, std::string& bytes) {
  constexpr std::size_t bits = 16;
  Codes words(numbers.size());
  for (std::size_t word = 0; word < 8 * sizeof(Number) / bits; ++word) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      words[i] = static_cast<std::uint16_t>(numbers[i] >> bits * word);
    append_planes(words, bytes);
  }
}

// Each number minus the one before it.
template <typename Unsigned, typename Number>
std::vector<Unsigned> steps_of(const std::vector<Number>& numbers) {
  std::vector<Unsigned> steps;
  Unsigned last = 0;
  for (const Number number : numbers) {
    steps.push_back(static_cast<Unsigned>(number) - last);
    last = static_cast<Unsigned>(number);
  }
  return steps;
}

Json number_or_null(double number) {
  return std::isnan(number) ? Json() : Json(number);
}

}  // namespace

ScenePacker::ScenePacker(const SceneRanges& ranges)
    : options_(ranges.options()),
      discs_(ranges.disc_quantisers()),
      contacts_(ranges.contact_quantisers()),
      last_(discs_.size()) {}

void ScenePacker::add(const Frame& frame) {
  SceneFrame scene = scene_frame(frame, options_.height > 0 ? options_.height : 1);
  const bool new_ids = scene.ids != ids_;
  std::string bytes;
  add_discs(scene, new_ids, bytes);
  add_contacts(scene, bytes);
  packed_.add(bytes);
  const double time =
      options_.time_step > 0 ? options_.time_step * static_cast<double>(frame.step) : frame.time;
  const Box& box = frame.box;
  frames_.push_back({{"index", frame.index},
                     {"run", frame.run},
                     {"step", frame.step},
                     {"time", number_or_null(time)},
                     {"discs", scene.ids.size()},
                     {"contacts", scene.first.size()},
                     {"new_ids", new_ids},
                     {"periodic", {box.periodic[0], box.periodic[1]}},
                     {"box", {box.low.x(), box.high.x(), box.low.y(), box.high.y()}}});
  ids_ = std::move(scene.ids);
}

void ScenePacker::add_discs(const SceneFrame& scene, bool new_ids, std::string& bytes) {
  if (new_ids) append_words(steps_of<std::uint64_t>(scene.ids), bytes);
  for (std::size_t column = 0; column < discs_.size(); ++column) {
    if (!discs_[column]) continue;
    Codes codes = codes_of(scene.discs[column], *discs_[column]);
    append_planes(new_ids ? codes : differences(codes, last_[column]), bytes);
    last_[column] = std::move(codes);
  }
}

void ScenePacker::add_contacts(const SceneFrame& scene, std::string& bytes) const {
  append_words(steps_of<std::uint32_t>(scene.first), bytes);
  std::vector<std::uint32_t> apart(scene.first.size());
  for (std::size_t i = 0; i < apart.size(); ++i) apart[i] = scene.second[i] - scene.first[i];
  append_words(apart, bytes);
  for (std::size_t column = 0; column < contacts_.size(); ++column)
    if (contacts_[column]) append_planes(codes_of(scene.contacts[column], *contacts_[column]), bytes);
}

}  // namespace mikromakro
