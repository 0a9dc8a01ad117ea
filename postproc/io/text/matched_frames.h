// SPDX-License-Identifier: GPL-2.0-or-later
// Frames common to several kinds of files: particles and contacts, each possibly split into pieces.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/files/file_sequence.h"
#include "io/frames/frame_selection.h"

namespace mikromakro {

/// Options of the matching.
struct Matching {
  FrameSelection selection;  ///< unmatched frames of other steps are omitted silently
  bool look_through = false;
  std::shared_ptr<Notes> notes;
};

/// Advances through several sequences of files in parallel and stops where all have a frame of the same step;
/// frames missing from some of them are left out and noted. Throws if no step is in all of them, and if the
/// number of pieces of a dump (files that begin with the same step, if `Reader` supports pieces) changes at
/// later steps.
template <typename Header, typename Block>
class MatchedFrames {
 public:
  explicit MatchedFrames(Matching matching) : matching_(std::move(matching)) {}

  /// Adds one sequence per piece of the dump, at least one. `Reader` opens its files.
  template <typename Reader>
  void add(const std::vector<std::string>& files) {
    for (std::vector<std::string>& piece : pieces_of<Reader>(files)) {
      auto sequence =
          std::make_unique<FileSequence<Reader>>(std::move(piece), matching_.look_through, matching_.notes);
      lanes_.push_back({std::move(sequence), {}, false});
    }
  }

  std::size_t size() const { return lanes_.size(); }

  bool next() {
    for (Lane& lane : lanes_) advance(lane);
    while (std::all_of(lanes_.begin(), lanes_.end(), [](const Lane& lane) { return lane.there; })) {
      const auto order = [](const Lane& a, const Lane& b) { return a.header.order() < b.header.order(); };
      const auto [first, last] = std::minmax_element(lanes_.begin(), lanes_.end(), order);
      if (first->header.same_time(last->header)) {
        ++matched_;
        return true;
      }
      leave_out(*first, last->header.time_text() + " there");
      advance(*first);
    }
    for (Lane& lane : lanes_)
      for (; lane.there; advance(lane)) leave_out(lane, "no more frames there");
    if (matched_ == 0 && !first_alone_.empty()) throw Error(Error::Kind::bad_input, first_alone_);
    return false;
  }

  const Header& header(std::size_t lane) const { return lanes_[lane].header; }
  const std::string& file(std::size_t lane) const { return lanes_[lane].files->file(); }

  /// The rows of all sequences, in the order of add(); empty if a truncated file ends among them.
  std::vector<std::shared_ptr<const Block>> take_rows() {
    std::vector<std::shared_ptr<const Block>> blocks;
    for (Lane& lane : lanes_) {
      std::optional<Block> block = lane.files->take_rows(lane.header);
      if (!block) return {};
      blocks.push_back(std::make_shared<const Block>(std::move(*block)));
    }
    return blocks;
  }

  std::int64_t bytes_read() const {
    std::int64_t sum = 0;
    for (const Lane& lane : lanes_) sum += lane.files->bytes_read();
    return sum;
  }

 private:
  struct Lane {
    std::unique_ptr<FrameFiles<Header, Block>> files;
    Header header;
    bool there = false;
  };

  static void advance(Lane& lane) { lane.there = lane.files->next(lane.header); }

  // Groups the files by their first frames; files that begin at the same time are pieces of one dump.
  template <typename Reader>
  static std::vector<std::vector<std::string>> pieces_of(const std::vector<std::string>& files) {
    std::vector<std::pair<decltype(Header().order()), std::string>> by_order;
    for (const std::string& file : files) {
      Header header;
      Reader(file).next_header(header);
      by_order.emplace_back(header.order(), file);
    }
    std::stable_sort(by_order.begin(), by_order.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    const auto first_group = std::count_if(by_order.begin(), by_order.end(), [&](const auto& entry) {
      return entry.first == by_order[0].first;
    });
    std::vector<std::vector<std::string>> pieces(Reader::has_pieces ? static_cast<std::size_t>(first_group)
                                                                    : 1);
    for (std::size_t i = 0; i < by_order.size(); ++i) {
      const std::size_t piece = i % pieces.size();
      if (piece > 0 && by_order[i].first != by_order[i - piece].first)
        throw bad_input({by_order[i].second}, "a piece of a step is missing",
                        fmt::format("{} files of step {}", pieces.size(), by_order[i - piece].first),
                        fmt::format("{}", piece));
      pieces[piece].push_back(std::move(by_order[i].second));
    }
    return pieces;
  }

  void leave_out(Lane& alone, const std::string& there) {
    const Header& header = alone.header;
    const std::string& file = alone.files->file();
    if (matched_ == 0 && first_alone_.empty())
      first_alone_ = bad_input({file, header.line}, "no frame is in all files",
                               header.time_text() + " in particles and contacts", there)
                         .what();
    const FrameSelection& asked = matching_.selection;
    if (header.step >= asked.first_step && header.step <= asked.last_step)
      matching_.notes->add(alone.files->name() + ": frames that the other files do not have are left out",
                           header.step);
  }

  Matching matching_;
  std::vector<Lane> lanes_;
  std::int64_t matched_ = 0;
  std::string first_alone_;  ///< the error if no frame matches
};

}  // namespace mikromakro
