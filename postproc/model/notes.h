// SPDX-License-Identifier: GPL-2.0-or-later
// What stops nothing but must be known: the warnings that the program tells and writes above its tables.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace mikromakro {

/// Collects texts, each once, from any thread. The library adds, the program tells.
class Notes {
 public:
  /// A note about the input as a whole.
  static constexpr std::int64_t whole = -1;

  /// `text` is one line as it shall be told, and the same for all frames that it is about ('p.dump: discs
  /// outside the box'). `count`: how often in the frame of this step. A frame that is read again, or by
  /// several ranks, counts once.
  void add(std::string_view text, std::int64_t step = whole, std::int64_t count = 1);

  /// Takes over what another one holds.
  void add(const Notes& other);

  /// The texts with their counts, 'TEXT (12 times in 3 frames, first in step 800)', in the order of the steps
  /// at which they first came up: the same however many threads have added.
  std::vector<std::string> lines() const;

  /// All of it as bytes, to send it from rank to rank.
  std::string packed() const;
  void add_packed(std::string_view bytes);

 private:
  using CountByStep = std::map<std::int64_t, std::int64_t>;

  mutable std::mutex mutex_;
  std::map<std::string, CountByStep, std::less<>> notes_;
};

}  // namespace mikromakro
