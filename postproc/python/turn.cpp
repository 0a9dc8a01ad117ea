// SPDX-License-Identifier: GPL-2.0-or-later
#include "python/turn.h"

#include <mutex>
#include <utility>

#include "model/error.h"

namespace py = pybind11;

namespace mikromakro {
namespace {

// Recursive since a stream may be closed by the thread that has the turn.
std::recursive_mutex turns;
std::mutex closing;
std::vector<std::unique_ptr<FrameStream>> to_close;
thread_local bool in_python = false;

void close_streams() {
  std::vector<std::unique_ptr<FrameStream>> streams;
  {
    const std::scoped_lock lock(closing);
    streams.swap(to_close);
  }
}

}  // namespace

Turn::Turn() {
  if (in_python)
    throw run_failed("mikromakro was called by a function that it calls",
                     "no such call in a field or in progress=", "one");
  turns.lock();
  close_streams();
}

Turn::~Turn() {
  turns.unlock();
}

void Turn::close(std::unique_ptr<FrameStream> stream) noexcept {
  if (turns.try_lock()) {
    stream.reset();
    turns.unlock();
  } else {
    const std::scoped_lock lock(closing);
    to_close.push_back(std::move(stream));
  }
}

InPython::InPython() {
  in_python = true;
}

InPython::~InPython() {
  in_python = false;
}

void CallListener::progress(double part, std::int64_t frames) {
  constexpr auto interval = std::chrono::milliseconds(50);
  const auto now = Clock::now();
  if (now - last_ < interval) return;
  last_ = now;
  const InPython lock;
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (part >= 0 && !progress_.is_none()) progress_(part, frames);
}

void CallListener::warn(const py::object& with) {
  for (const std::string& text : std::exchange(warnings_, {})) with(text);
}

}  // namespace mikromakro
