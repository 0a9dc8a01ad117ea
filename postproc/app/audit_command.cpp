// SPDX-License-Identifier: GPL-2.0-or-later
#include <fmt/format.h>

#include <memory>

#include "app/commands.h"
#include "verbs/audits.h"

namespace mikromakro {

void add_audit_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("audit", "balances of torque, stress, forces and volume over rings or a box");
  auto options = std::make_shared<AuditOptions>();
  add_audit_options(*app, *options);
  app->callback([options] {
    const AuditReport report = audit(*options);
    fmt::print("{}", options->json ? text_of(report.json) + "\n" : report.text);
    check_bound(report, options->bound);
  });
}

}  // namespace mikromakro
