#include "app/audit_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "io/error.h"

namespace mikromakro {

void print_balances(const Balances& balances) {
  for (const Balance& balance : balances)
    fmt::print("{:<9} {:>10.3e}  {}\n", balance.name, balance.value, balance.text);
}

void add_balances(JsonObject& json, const Balances& balances) {
  for (const Balance& balance : balances) json.add(balance.name, balance.value);
}

void check_bound(const Balances& balances, double bound) {
  if (std::isnan(bound)) return;
  std::vector<std::string> off;
  for (const Balance& balance : balances) {
    if (balance.judged && !(balance.value <= bound))
      off.push_back(fmt::format("{} {:.3g}", balance.name, balance.value));
  }
  if (!off.empty())
    throw run_failed("balances are off", fmt::format("at most {}", bound),
                     fmt::format("{}", fmt::join(off, ", ")));
}

}  // namespace mikromakro
