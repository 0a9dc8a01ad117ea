// SPDX-License-Identifier: GPL-2.0-or-later
// The audit of a page, in plain words.
#pragma once

#include "io/tables/json.h"
#include "options/average_options.h"
#include "verbs/audit_input.h"

namespace mikromakro {

/// The audit of the averaged volumes: whole rings without sectors, boxes with the weights that an audit
/// takes.
AuditOptions audit_options(const InputOptions& input, const AverageOptions& average);

/// For each balance its name, a question, the answer in words, and how the number is defined. If the audit
/// is not possible, the reason under `impossible`.
Json audit_json(AuditOptions options);

}  // namespace mikromakro
