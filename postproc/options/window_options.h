// SPDX-License-Identifier: GPL-2.0-or-later
// Options for averages as functions of time.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>

#include "averaging/windows.h"
#include "io/tables/csv_writer.h"
#include "model/notes.h"

namespace mikromakro {

struct WindowOptions {
  std::int64_t every = 0;   ///< frames of each window; 0: not given
  std::int64_t moving = 0;  ///< frames of overlapping windows; 0: not given
  bool per_frame = false;
  double time_step = 0;  ///< s; 0: not given

  bool any() const { return every > 0 || moving > 0 || per_frame; }
};

void add_window_options(CLI::App& app, WindowOptions& options);

/// Throws if the options contradict each other, or none asks for windows although others need them.
void check_windows(const WindowOptions& options);

/// Call only if any().
WindowRule rule_of(const WindowOptions& options);

/// The option that asks for the windows, with its dashes.
std::string_view window_option(const WindowOptions& options);

/// Throws if no window is full; else notes the frames that are left out. Call after the last frame.
void check_windows(const WindowOptions& options, const Windows& windows, Notes& notes);

/// Header lines of a table.
void describe_windows(const WindowOptions& options, std::int64_t windows, Preamble& lines);

}  // namespace mikromakro
