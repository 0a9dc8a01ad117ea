// SPDX-License-Identifier: GPL-2.0-or-later
#include <memory>

#include "app/commands.h"
#include "verbs/draw.h"

namespace mikromakro {

void add_draw_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand("draw", "discs, contact network and force chains as PNG or SVG");
  auto options = std::make_shared<DrawOptions>();
  add_draw_options(*app, *options);
  app->callback([options] { draw(*options); });
}

}  // namespace mikromakro
