// SPDX-License-Identifier: GPL-2.0-or-later
// Warnings: non-fatal findings, which the program prints and writes above its tables.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace mikromakro {

/// Collects texts, each once; thread-safe. The library adds notes, the program prints them.
class Notes {
 public:
  /// Step of a note that concerns the input as a whole.
  static constexpr std::int64_t whole = -1;

  /// `text` is one line in its final wording, identical for all frames it refers to ('p.dump: discs outside
  /// the box'). `count`: number of occurrences in the frame of this step. A frame that is read again, or by
  /// several ranks, counts once.
  void add(std::string_view text, std::int64_t step = whole, std::int64_t count = 1);

  /// A finding that single frames may show by chance: it is a note if at least half of the frames that are
  /// judged have it.
  void judge(std::string_view text, bool found, std::int64_t step, std::int64_t count = 1);

  /// Merges the notes of another object.
  void add(const Notes& other);

  /// The texts with their counts, 'TEXT (12 times in 3 frames, first in step 800)', ordered by the step of
  /// first occurrence: independent of the number of threads.
  std::vector<std::string> lines() const;

  /// Serialised, to send between ranks.
  std::string packed() const;
  void add_packed(std::string_view bytes);

 private:
  using CountByStep = std::map<std::int64_t, std::int64_t>;

  mutable std::mutex mutex_;
  std::map<std::string, CountByStep, std::less<>> notes_;
};

}  // namespace mikromakro
