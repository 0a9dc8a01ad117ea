// SPDX-License-Identifier: GPL-2.0-or-later
// The contacts of each disc of a frame.
#pragma once

#include <span>
#include <vector>

#include "model/frame.h"

namespace mikromakro {

/// A contact as seen from one of its discs.
struct ContactEnd {
  int contact;  ///< index in Frame::contacts
  bool first;   ///< whether this disc is disc 1 of the contact
};

/// Contact lists per disc, each in row order, which fixes the order of all later sums.
class ContactLists {
 public:
  explicit ContactLists(const Frame& frame);

  std::span<const ContactEnd> of(int particle) const {
    const auto index = static_cast<std::size_t>(particle);
    return {ends_.data() + begin_[index], begin_[index + 1] - begin_[index]};
  }

 private:
  std::vector<std::size_t> begin_;
  std::vector<ContactEnd> ends_;
};

}  // namespace mikromakro
