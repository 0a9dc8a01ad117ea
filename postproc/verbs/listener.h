// SPDX-License-Identifier: GPL-2.0-or-later
// Warnings and progress for callers that are not a terminal.
#pragma once

#include <cstdint>
#include <string>

namespace mikromakro {

/// Receives the warnings and the progress of the verbs called in the thread that created it, in place of
/// stderr, while it lives; one at a time in a thread.
class Listener {
 public:
  Listener();
  virtual ~Listener();
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  virtual void warning(const std::string& text) = 0;
  /// Called for every frame; an exception ends the verb. `part`: of the input that is read.
  virtual void progress(double part, std::int64_t frames) = 0;

  /// Called between frames where there is no progress to show; an exception ends the verb.
  virtual void pause() = 0;

  /// The one of this thread, or null.
  static Listener* of_this_thread();
};

}  // namespace mikromakro
