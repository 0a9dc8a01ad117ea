// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/page.h"

#include <fmt/format.h>

#include <cmath>

#include "drawing/colour.h"
#include "drawing/picture.h"
#include "report/page_parts.h"

namespace mikromakro {
namespace {

// Enough for neighbouring colours to look the same, and few enough to draw discs by colour.
constexpr int map_colours = 128;

std::string css(const Colour& colour) {
  const auto byte = [](double part) { return std::lround(255 * part); };
  return fmt::format("rgba({}, {}, {}, {})", byte(colour.red), byte(colour.green), byte(colour.blue),
                     colour.alpha);
}

// '<' can only stand within strings of JSON, where it may be written like this.
std::string harmless(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char letter : json) {
    if (letter == '<') {
      text += "\\u003c";
    } else {
      text += letter;
    }
  }
  return text;
}

}  // namespace

Json colours_json() {
  Json map = Json::array();
  for (int i = 0; i < map_colours; ++i) map.push_back(css(viridis((i + 0.5) / map_colours)));
  return {{"map", map},
          {"wall", css(colours::wall)},
          {"plain", css(colours::plain)},
          {"outline", css(colours::outline)},
          {"network", css(colours::network)},
          {"compression", css(colours::compression)},
          {"tension", css(colours::tension)},
          {"halo", css(colours::halo)},
          {"chain_width", chain_width},
          {"network_width", network_width},
          {"halo_width", halo_width}};
}

std::string page_html(const Json& data, std::string_view scene) {
  std::string page(page_before_data);
  page.append(harmless(text_of(data)));
  page.append(page_before_scene).append(scene).append(page_after_scene);
  return page;
}

}  // namespace mikromakro
