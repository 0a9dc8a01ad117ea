#include <memory>

#include "app/audits.h"
#include "app/commands.h"

namespace mikromakro {

void add_audit_command(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("audit", "balances of torque, stress, forces and volume over rings or a box");
  auto options = std::make_shared<AuditOptions>();
  add_audit_options(*app, *options);
  app->callback([options] {
    const bool rings = !options->volumes.rings.empty() || !options->volumes.edges.empty();
    reading_again(options->input,
                  [&] { check_bound(rings ? audit_rings(*options) : audit_box(*options), options->bound); });
  });
}

}  // namespace mikromakro
