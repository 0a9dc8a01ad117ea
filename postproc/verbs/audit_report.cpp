// SPDX-License-Identifier: GPL-2.0-or-later
#include "verbs/audit_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>
#include <limits>

#include "model/error.h"

namespace mikromakro {

Balance law_balance(const NormalForces& forces) {
  if (std::isnan(forces.stiffness()))
    return {"law", std::numeric_limits<double>::quiet_NaN(), "no contacts of two discs", false};
  const std::string slope = fmt::format("f_n/overlap is {:.6g} N/m on average", forces.stiffness());
  if (forces.stiffness_is_known())
    return {"law", forces.deviation(),
            "mean |f_n - k_n overlap| of two discs over the mean k_n overlap; " + slope};
  return {"law", forces.pulling(),
          "fraction of the normal forces between discs that are attractive; without --kn, magnitudes are not "
          "judged: " +
              slope};
}

std::string number_or_dash(double value, int width, std::string_view format) {
  if (std::isnan(value)) return fmt::format("{:>{}}", '-', width);
  return fmt::format("{:>{}}", fmt::format(fmt::runtime(format), value), width);
}

void add_balances(std::string& text, const Balances& balances) {
  for (const Balance& balance : balances)
    fmt::format_to(std::back_inserter(text), "{:<9} {}  {}\n", balance.name,
                   number_or_dash(balance.value, 10, "{:.3e}"), balance.text);
}

void add_balances(Json& json, const Balances& balances) {
  for (const Balance& balance : balances) json[balance.name] = balance.value;
}

void check_bound(const Balances& balances, double bound) {
  if (std::isnan(bound)) return;
  std::vector<std::string> off;
  for (const Balance& balance : balances) {
    if (!balance.judged || balance.value <= bound) continue;
    off.push_back(std::isnan(balance.value) ? fmt::format("{} unknown: {}", balance.name, balance.text)
                                            : fmt::format("{} {:.3g}", balance.name, balance.value));
  }
  if (!off.empty())
    throw run_failed("balances are off", fmt::format("at most {}", bound),
                     fmt::format("{}", fmt::join(off, ", ")));
}

void check_bound(const AuditReport& report, double bound) {
  if (report.off) throw Error(*report.off);
  check_bound(report.balances, bound);
}

}  // namespace mikromakro
