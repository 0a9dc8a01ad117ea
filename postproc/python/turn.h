// SPDX-License-Identifier: GPL-2.0-or-later
// Calls from Python: one at a time, without its lock, and with its interrupts.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include "io/frames/frame_stream.h"
#include "verbs/listener.h"

namespace mikromakro {

/// The right to use HDF5, which serves one thread at a time. Waits for it; call without Python's lock. Throws
/// inside of a function that a verb calls, where waiting would never end.
class Turn {
 public:
  Turn();
  ~Turn();
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

  /// Closes a stream, now or in the next turn; for destructors, which must not wait.
  static void close(std::unique_ptr<FrameStream> stream) noexcept;
};

/// Python's lock, for a function of the caller.
class InPython {
 public:
  InPython();
  ~InPython();
  InPython(const InPython&) = delete;
  InPython& operator=(const InPython&) = delete;

 private:
  pybind11::gil_scoped_acquire lock_;
};

/// Collects warnings, passes progress on to a function, and lets Ctrl-C end the verb.
class CallListener : public Listener {
 public:
  explicit CallListener(pybind11::object progress) : progress_(std::move(progress)) {}

  void warning(const std::string& text) override { warnings_.push_back(text); }
  void progress(double part, std::int64_t frames) override;
  void pause() override { progress(-1, 0); }
  /// Gives the warnings to Python.
  void warn(const pybind11::object& with);

 private:
  using Clock = std::chrono::steady_clock;
  pybind11::object progress_;
  std::vector<std::string> warnings_;
  Clock::time_point last_ = {};
};

/// What Python gives to every call.
struct Hooks {
  pybind11::object progress;  ///< called with (part, frames); or None
  pybind11::object warn;      ///< called with each warning
};

/// Runs `work` in a turn, without Python's lock; warnings follow, also those before an error.
template <typename Work>
auto in_turn(const Hooks& hooks, const Work& work) {
  CallListener listener(hooks.progress);
  const auto run = [&] {
    const pybind11::gil_scoped_release unlocked;
    const Turn turn;
    return work();
  };
  try {
    auto result = run();
    listener.warn(hooks.warn);
    return result;
  } catch (const Error&) {
    listener.warn(hooks.warn);
    throw;
  }
}

}  // namespace mikromakro
