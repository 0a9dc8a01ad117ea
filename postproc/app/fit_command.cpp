// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <memory>

#include "app/commands.h"
#include "verbs/fit.h"

namespace mikromakro {

void add_fit_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("fit", "exponential velocity profile v0 exp(-(r - R_i)/s), of windows too");
  auto options = std::make_shared<FitOptions>();
  add_fit_options(*app, *options);
  app->callback([options] {
    const FitResult result = fit(*options);
    fmt::print("{}", options->json ? text_of(result.json) + "\n" : result.text);
  });
}

}  // namespace mikromakro
