// SPDX-License-Identifier: GPL-2.0-or-later
// report.html with its style sheet and scripts, as made by cmake/embed_page.py when the program is built.
#pragma once

#include <string_view>

namespace mikromakro {

extern const std::string_view page_before_data;
extern const std::string_view page_before_scene;
extern const std::string_view page_after_scene;

}  // namespace mikromakro
