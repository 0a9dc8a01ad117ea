// SPDX-License-Identifier: GPL-2.0-or-later
// The frames of several files of one kind, as one sequence.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/error.h"
#include "model/notes.h"

namespace mikromakro {

/// A sequence of frames, independent of the reader.
template <typename Header, typename Block>
class FrameFiles {
 public:
  FrameFiles() = default;
  FrameFiles(const FrameFiles&) = delete;
  FrameFiles& operator=(const FrameFiles&) = delete;
  virtual ~FrameFiles() = default;

  virtual bool next(Header& header) = 0;
  /// The rows below that header; none if a truncated file ends among them.
  virtual std::optional<Block> take_rows(const Header& header) = 0;
  /// The file that holds that header, and a name for all files.
  virtual const std::string& file() const = 0;
  virtual std::string name() const = 0;
  virtual std::int64_t bytes_read() const = 0;
};

/// Reads files in the given order, which must be that of their first frames. `Reader` opens a file by name
/// and has a Header with its position in time (`order()`) and its line.
///
/// Time steps repeat if a run was continued from a restart file: frames followed by one with the same or an
/// earlier step are superseded and do not count. They can only be identified by scanning all files first,
/// which `look_through` requests; without it, such a step throws (Kind::steps_come_again).
template <typename Reader>
class FileSequence : public FrameFiles<typename Reader::Header, typename Reader::Block> {
 public:
  using Header = typename Reader::Header;
  using Block = typename Reader::Block;
  using Order = decltype(Header().order());

  FileSequence(std::vector<std::string> files, bool look_through, std::shared_ptr<Notes> notes)
      : files_(std::move(files)), notes_(std::move(notes)) {
    if (look_through) find_replaced();
  }

  bool next(Header& header) override {
    while (next_of_all(header)) {
      ++frames_;
      if (!replaced_.empty() && replaced_[frames_ - 1]) {
        notes_->add(fmt::format("{}: {}", name(), replaced_text), header.step);
        continue;
      }
      check_order(header);
      last_ = header.order();
      return true;
    }
    return false;
  }

  std::optional<Block> take_rows(const Header& header) override { return reader_->take_rows(header); }
  const std::string& file() const override { return reader_->file(); }
  std::string name() const override {
    return files_.size() == 1 ? files_[0] : fmt::format("{} to {}", files_.front(), files_.back());
  }
  std::int64_t bytes_read() const override { return bytes_before_ + (reader_ ? reader_->bytes_read() : 0); }

 private:
  static constexpr std::string_view replaced_text =
      "frames whose steps occur again later in the files (a run continued from a restart file) are left out";

  bool next_of_all(Header& header) {
    while (!reader_ || !reader_->next_header(header)) {
      if (reader_ && reader_->cut())
        notes_->add(reader_->file() +
                    ": the compressed file is truncated: only its complete frames are used");
      if (opened_ == files_.size()) return false;
      bytes_before_ = bytes_read();
      reader_ = std::make_unique<Reader>(files_[opened_++]);
    }
    return true;
  }

  void check_order(const Header& header) const {
    if (!last_ || header.order() > *last_) return;
    throw Error(Error::Kind::steps_come_again,
                bad_input({reader_->file(), header.line}, Reader::not_ascending,
                          fmt::format("more than {}", *last_), fmt::format("{}", header.order()))
                    .what());
  }

  // For each complete frame, in file order: whether a later one has the same or an earlier time.
  void find_replaced() {
    std::vector<Order> orders;
    for (const std::string& file : files_) {
      Reader reader(file);
      Header header;
      while (reader.next_header(header)) {
        // An incomplete frame supersedes none.
        const bool complete = reader.take_rows(header).has_value();
        orders.push_back(complete ? header.order() : std::numeric_limits<Order>::max());
      }
    }
    replaced_.resize(orders.size());
    Order earliest = std::numeric_limits<Order>::max();
    for (std::size_t i = orders.size(); i-- > 0;) {
      replaced_[i] = orders[i] >= earliest;
      earliest = std::min(earliest, orders[i]);
    }
  }

  std::vector<std::string> files_;
  std::shared_ptr<Notes> notes_;
  std::vector<bool> replaced_;
  std::size_t frames_ = 0;
  std::size_t opened_ = 0;
  std::unique_ptr<Reader> reader_;
  std::optional<Order> last_;
  std::int64_t bytes_before_ = 0;
};

}  // namespace mikromakro
