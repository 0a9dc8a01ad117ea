// SPDX-License-Identifier: GPL-2.0-or-later
// A page that holds its data, style sheet and scripts.
#pragma once

#include <string>
#include <string_view>

#include "io/tables/json.h"

namespace mikromakro {

/// The colours of `mikromakro draw`, as CSS.
Json colours_json();

/// The page of report.html around the data. Nothing within `data` can end the element that it is in or begin
/// another one; `scene` is base64.
std::string page_html(const Json& data, std::string_view scene);

}  // namespace mikromakro
