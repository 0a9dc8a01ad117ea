// The frames of several files of one kind as one sequence.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/error.h"

namespace mikromakro {

/// Files in the order of their first frames. `Reader` opens a file by its name and has a Header that tells
/// its place in time (`order()`) and its line. Throws when frames do not ascend.
template <typename Reader>
class FileSequence {
 public:
  using Header = typename Reader::Header;

  explicit FileSequence(const std::vector<std::string>& files) {
    std::vector<std::pair<decltype(Header().order()), std::string>> by_order;
    by_order.reserve(files.size());
    for (const std::string& file : files) {
      Header header;
      Reader(file).next_header(header);
      by_order.emplace_back(header.order(), file);
    }
    std::stable_sort(by_order.begin(), by_order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& [order, file] : by_order) files_.push_back(std::move(file));
  }

  bool next(Header& header) {
    while (!reader_ || !reader_->next_header(header)) {
      if (opened_ == files_.size()) return false;
      bytes_before_ = bytes_read();
      reader_ = std::make_unique<Reader>(files_[opened_++]);
    }
    if (last_ && header.order() <= *last_) {
      throw bad_input({reader_->file(), header.line}, Reader::not_ascending,
                      fmt::format("more than {}", *last_), fmt::format("{}", header.order()));
    }
    last_ = header.order();
    return true;
  }

  Reader& reader() { return *reader_; }
  std::int64_t bytes_read() const { return bytes_before_ + (reader_ ? reader_->bytes_read() : 0); }

 private:
  std::vector<std::string> files_;
  std::size_t opened_ = 0;
  std::unique_ptr<Reader> reader_;
  std::optional<decltype(Header().order())> last_;
  std::int64_t bytes_before_ = 0;
};

}  // namespace mikromakro
