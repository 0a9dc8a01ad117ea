// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/report_audit.h"

#include <fmt/format.h>

#include <cmath>

#include "averaging/weight.h"
#include "model/error.h"
#include "verbs/audits.h"

namespace mikromakro {
namespace {

// A balance as somebody asks for it who does not know the formula.
struct Question {
  std::string_view name, question, answer;
};
constexpr Question questions[] = {
    {"torque", "Does every ring carry the torque of the wheel?", "to within {}"},
    {"radial", "Do the stresses balance in the radial direction?", "to within {} of the pressure"},
    {"stress", "Is the stress of the discs that of the boundary?", "to within {} of the pressure"},
    {"walls", "Do the walls feel the stress of the discs?", "to within {} of the pressure"},
    {"forces", "Do the forces of all walls cancel?", "to within {} of one of them"},
    {"residual", "Are the discs in equilibrium?", "their net forces are {} of their contact forces"},
    {"volume", "Is every disc counted once?", "the volumes add up to within {}"},
    {"momentum", "Is momentum balanced in every cell?", "to within {} of the pressure"},
};
constexpr Question law = {"law", "Are the normal forces those of the overlaps?",
                          "they differ by {} on average"};
constexpr Question pulling = {"law", "Do discs pull each other?", "{} of the normal forces between discs do"};

const Question& question_of(const std::string& name, bool stiffness_known) {
  for (const Question& one : questions)
    if (one.name == name) return one;
  return stiffness_known ? law : pulling;
}

// Two digits are all that such a number is good for; errors of rounding are called so.
std::string percent(double part) {
  constexpr double rounding = 1e-9;
  if (part == 0 || part >= 1) return fmt::format("{:.0f} %", 100 * part);
  return part < rounding ? fmt::format("rounding ({:.0e})", part) : fmt::format("{:.2g} %", 100 * part);
}

Json balance_json(const Balance& balance, bool stiffness_known) {
  const Question& words = question_of(balance.name, stiffness_known);
  const bool known = !std::isnan(balance.value);
  const std::string answer =
      known ? fmt::format(fmt::runtime(words.answer), percent(balance.value)) : "not known";
  return {{"name", balance.name},   {"question", words.question}, {"answer", answer},
          {"value", balance.value}, {"judged", balance.judged},   {"text", balance.text}};
}

}  // namespace

AuditOptions audit_options(const InputOptions& input, const AverageOptions& average) {
  AuditOptions audit;
  audit.input = input;
  audit.volumes = average.volumes;
  audit.volumes.sectors = 0;
  if (!of_rings(audit.volumes)) {
    audit.volumes.branch.clear();
    const bool kernel = !audit.volumes.grid.empty() && make_weight(audit.volumes.weight)->is_kernel();
    if (!kernel) audit.volumes.weight.clear();
  }
  if (average.fields.numbers.normal_stiffness > 0) audit.kn = average.fields.numbers.normal_stiffness;
  return audit;
}

Json audit_json(AuditOptions options) {
  try {
    complete(options);
    const std::unique_ptr<Auditor> auditor =
        of_rings(options.volumes) ? ring_auditor(options) : box_auditor(options);
    const FrameSource source = auditor->source();
    read_frames(source, options, [&](const Frame& frame) { return auditor->add(frame, *source.notes); });
    Json list = Json::array();
    for (const Balance& one : auditor->balances()) list.push_back(balance_json(one, !std::isnan(options.kn)));
    return {{"balances", list}};
  } catch (const Error& error) {
    if (error.kind() == Error::Kind::steps_come_again) throw;
    return {{"impossible", error.what()}};
  }
}

}  // namespace mikromakro
