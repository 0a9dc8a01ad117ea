// SPDX-License-Identifier: GPL-2.0-or-later
// Checks that each pair is listed once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/contact_rows.h"
#include "model/frame.h"
#include "model/notes.h"

namespace mikromakro {

/// Which row each contact comes from: contacts are the rows in their order, without some.
class RowOfContact {
 public:
  /// Ascending.
  void leave_out(std::size_t row) { left_out_.push_back(row); }
  std::size_t left_out() const { return left_out_.size(); }

  std::size_t operator[](std::size_t contact) const {
    // left_out_[i] - i contacts are before the i-th row that is left out.
    const auto end = std::partition_point(left_out_.begin(), left_out_.end(), [&](const std::size_t& row) {
      return row - static_cast<std::size_t>(&row - left_out_.data()) <= contact;
    });
    return contact + static_cast<std::size_t>(end - left_out_.begin());
  }

 private:
  std::vector<std::size_t> left_out_;
};

/// Throws on a pair that is listed twice, except through different periodic images or on several faces of a
/// mesh, and on a wall contact that is present in both files under different wall ids.
void check_pairs(const std::vector<Contact>& contacts, const RowOfContact& row_of, const ContactRows& rows,
                 const std::vector<Particle>& discs, const Box& box);

/// Notes discs that touch two walls on the same side by the same overlap. Both may act, where a script
/// defines a wall twice.
void note_walls_twice(const std::vector<Contact>& contacts, const std::vector<Particle>& discs, Notes& notes,
                      std::int64_t step);

}  // namespace mikromakro
