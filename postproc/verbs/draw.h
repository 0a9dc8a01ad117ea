// SPDX-License-Identifier: GPL-2.0-or-later
// `draw`: pictures of frames.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "drawing/picture.h"
#include "verbs/input_options.h"

namespace mikromakro {

struct DrawOptions {
  InputOptions input;
  std::string out, color;
  std::vector<double> box, range;
  PictureStyle style;
  double height = 0;        ///< 0: not given
  QuantityInfo quantity{};  ///< quantity of the style, with the unit used here
  bool quiet = false;
};

void add_draw_options(CLI::App& app, DrawOptions& options);

/// Draws the selected frames; returns the names of the files.
std::vector<std::string> draw(DrawOptions options);

}  // namespace mikromakro
