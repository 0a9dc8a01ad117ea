// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/contact_lists.h"

namespace mikromakro {

ContactLists::ContactLists(const Frame& frame) : begin_(frame.particles.size() + 1, 0) {
  for (const Contact& contact : frame.contacts) {
    ++begin_[static_cast<std::size_t>(contact.index1) + 1];
    if (contact.index2 >= 0) ++begin_[static_cast<std::size_t>(contact.index2) + 1];
  }
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  ends_.resize(begin_.back());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < frame.contacts.size(); ++i) {
    const Contact& contact = frame.contacts[i];
    ends_[next[static_cast<std::size_t>(contact.index1)]++] = {static_cast<int>(i), true};
    if (contact.index2 >= 0)
      ends_[next[static_cast<std::size_t>(contact.index2)]++] = {static_cast<int>(i), false};
  }
}

}  // namespace mikromakro
