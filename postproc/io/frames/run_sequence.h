// SPDX-License-Identifier: GPL-2.0-or-later
// Several runs in sequence.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "io/frames/frame_format.h"

namespace mikromakro {

/// Independent runs (different seeds, say), concatenated; time steps restart with each run.
class RunSequence : public FrameFormat {
 public:
  using Open = std::function<std::unique_ptr<FrameFormat>()>;

  explicit RunSequence(std::vector<Open> runs) : runs_(std::move(runs)) {}

  bool next(std::int64_t& step) override {
    while (!run_ || !run_->next(step)) {
      if (opened_ == runs_.size()) return false;
      bytes_before_ = bytes_read();
      run_ = runs_[opened_++]();
    }
    return true;
  }
  std::int64_t run() const override { return static_cast<std::int64_t>(opened_) - 1; }
  UnpackFrame take(bool closely) override { return run_->take(closely); }
  std::int64_t contact_rows() const override { return run_->contact_rows(); }
  std::int64_t bytes_read() const override { return bytes_before_ + (run_ ? run_->bytes_read() : 0); }

 private:
  std::vector<Open> runs_;
  std::size_t opened_ = 0;
  std::unique_ptr<FrameFormat> run_;
  std::int64_t bytes_before_ = 0;
};

}  // namespace mikromakro
