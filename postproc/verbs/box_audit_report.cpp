// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/box_audit_report.h"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <limits>

namespace mikromakro {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::string_view, box_walls> wall_names = {"left", "right", "bottom", "top"};
constexpr std::array<std::string_view, 4> components = {"xx", "xy", "yx", "yy"};

void add_stress(Json& json, std::string_view name, const Eigen::Matrix2d& stress) {
  for (std::size_t i = 0; i < 4; ++i)
    json[fmt::format("{}_sigma_{}", name, components[i])] =
        stress(static_cast<Eigen::Index>(i / 2), static_cast<Eigen::Index>(i % 2));
}

void add_walls(std::string& text, const BoxBalance& box, std::string_view unit) {
  // In the header, n is the axis normal to the wall.
  fmt::format_to(std::back_inserter(text), "{:>10} {:>14} {:>14} {:>14} {:>14}\n", "wall", "F_x/N", "F_y/N",
                 fmt::format("s_xn/{}", unit), fmt::format("s_yn/{}", unit));
  for (int number = 0; number < box_walls; ++number) {
    if (!box.may_have_wall(number)) continue;
    const WallStress wall = box.wall(number);
    fmt::format_to(std::back_inserter(text), "{:>10} {:>14.6g} {:>14.6g} {:>14.9g} {:>14.9g}\n",
                   wall_names[static_cast<std::size_t>(number)], wall.force[0], wall.force[1], wall.stress[0],
                   wall.stress[1]);
  }
}

}  // namespace

std::string text_of(const BoxAudit& audit) {
  std::string text;
  const Rectangle box = audit.box.box();
  if (audit.box.has_walls()) add_walls(text, audit.box, audit.units.stress);
  fmt::format_to(std::back_inserter(text), "{:>10} {:>14} {:>14} {:>14} {:>14}\n", "",
                 "s_xx/" + audit.units.stress, "s_xy/" + audit.units.stress, "s_yx/" + audit.units.stress,
                 "s_yy/" + audit.units.stress);
  const auto add = [&](std::string_view name, const Eigen::Matrix2d& stress) {
    fmt::format_to(std::back_inserter(text), "{:>10}", name);
    for (const double component : {stress(0, 0), stress(0, 1), stress(1, 0), stress(1, 1)})
      fmt::format_to(std::back_inserter(text), " {}", number_or_dash(component, 14, "{:.9g}"));
    text += "\n";
  };
  add("volume", audit.box.volume_stress());
  if (audit.box.has_boundary()) add("boundary", audit.box.boundary_stress());
  fmt::format_to(std::back_inserter(text),
                 "{} frames; box {:.9g} {:.9g} {:.9g} {:.9g} m; volume of discs {:.6g} {}; {}\n",
                 audit.box.frames(), box.low[0], box.high[0], box.low[1], box.high[1], audit.disc_volume,
                 audit.units.volume,
                 audit.box.is_cut()         ? "a part of the packing"
                 : audit.box.has_walls()    ? fmt::format("friction of walls {:.3g}", audit.box.friction())
                 : audit.box.has_boundary() ? "no contacts with walls -1 to -4"
                                            : "no contacts with walls");
  add_balances(text, audit.balances);
  return text;
}

Json json_of(const BoxAudit& audit) {
  Json json = Json::object();
  const Rectangle box = audit.box.box();
  json["frames"] = audit.box.frames();
  json["box"] = std::vector<double>{box.low[0], box.high[0], box.low[1], box.high[1]};
  json["volume_of_discs"] = audit.disc_volume;
  json["friction_of_walls"] = audit.box.friction();
  add_stress(json, "volume", audit.box.volume_stress());
  add_stress(json, "boundary",
             audit.box.has_boundary() ? audit.box.boundary_stress() : Eigen::Matrix2d::Constant(nan));
  for (int number = 0; number < box_walls; ++number) {
    if (!audit.box.has_walls() || !audit.box.may_have_wall(number)) continue;
    const WallStress wall = audit.box.wall(number);
    Json one = Json::object();
    one["force"] = std::vector<double>{wall.force[0], wall.force[1]};
    one["area"] = wall.area;
    one[number < 2 ? "sigma_xx" : "sigma_xy"] = wall.stress[0];
    one[number < 2 ? "sigma_yx" : "sigma_yy"] = wall.stress[1];
    json[wall_names[static_cast<std::size_t>(number)]] = one;
  }
  add_balances(json, audit.balances);
  const auto add = [&](std::string_view name, const auto& value_of) {
    std::vector<double> values;
    for (const CellBalance& cell : audit.cells) values.push_back(value_of(cell));
    json[name] = values;
  };
  add("x", [](const CellBalance& cell) { return cell.x; });
  add("y", [](const CellBalance& cell) { return cell.y; });
  add("momentum_x", [](const CellBalance& cell) { return cell.left[0]; });
  add("momentum_y", [](const CellBalance& cell) { return cell.left[1]; });
  return json;
}

}  // namespace mikromakro
