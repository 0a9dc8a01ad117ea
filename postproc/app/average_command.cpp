// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <memory>

#include "app/commands.h"
#include "verbs/average.h"

namespace mikromakro {

void add_average_command(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "average", "fields over rings, sectors or rectangles from particle and contact dumps");
  auto options = std::make_shared<AverageCommand>();
  add_average_command_options(*app, *options);
  app->callback([options] {
    const Ranks ranks;
    const AverageResult result = average(*options, ranks);
    if (options->json && ranks.first()) fmt::print("{}\n", text_of(result.error_report));
  });
}

}  // namespace mikromakro
