// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/parallel/ranks.h"

#include <mpi.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <limits>
#include <numeric>
#include <optional>
#include <string>

#include "model/error.h"

namespace mikromakro {
namespace {

int environment_number(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::atoi(text);
}

// What `action` throws, as an Error that all ranks can throw.
std::optional<Error> error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  } catch (const std::exception& error) {
    return Error(Error::Kind::run_failed, error.what());
  }
  return std::nullopt;
}

// Throws on all ranks if any has an error: the one with the smallest `order`, then the lowest rank.
void settle(const std::optional<Error>& own, std::int64_t order) {
  constexpr std::int64_t none = std::numeric_limits<std::int64_t>::max();
  int rank = 0;
  int size = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  const std::int64_t mine = own ? order : none;
  std::vector<std::int64_t> orders(static_cast<std::size_t>(size));
  MPI_Allgather(&mine, 1, MPI_INT64_T, orders.data(), 1, MPI_INT64_T, MPI_COMM_WORLD);
  const auto least = std::min_element(orders.begin(), orders.end());
  if (*least == none) return;
  const int from = static_cast<int>(least - orders.begin());
  std::string text = rank == from ? own->what() : std::string();
  std::int64_t kind_and_length[2] = {};
  if (rank == from) {
    kind_and_length[0] = static_cast<std::int64_t>(own->kind());
    kind_and_length[1] = static_cast<std::int64_t>(text.size());
  }
  MPI_Bcast(kind_and_length, 2, MPI_INT64_T, from, MPI_COMM_WORLD);
  text.resize(static_cast<std::size_t>(kind_and_length[1]));
  MPI_Bcast(text.data(), static_cast<int>(text.size()), MPI_CHAR, from, MPI_COMM_WORLD);
  throw Error(static_cast<Error::Kind>(kind_and_length[0]), text);
}

// Collects the sums of this rank and exchanges them in rounds in which every unfinished rank has the same
// number of frames, so that no frame of a later round precedes one of the current round.
class Rounds {
 public:
  Rounds(const Ranks& ranks, const TakeSums& take, std::int64_t most_bytes)
      : ranks_(ranks), take_(take), most_bytes_(most_bytes) {}

  void add(const FrameSums& sums) {
    waiting_.push_back(sums);
    const auto frames =
        std::max<std::int64_t>(1, most_bytes_ / (8 * std::max<Eigen::Index>(1, sums.sums.size())));
    if (std::ssize(waiting_) >= std::min(frames, most_frames)) exchange(std::nullopt, false);
  }

  // True when all ranks are finished.
  bool exchange(const std::optional<Error>& own, bool at_end) {
    over_ = true;  // if this throws, all ranks throw
    settle(own, std::ssize(waiting_));
    collect(at_end);
    ranks_.agree([this] {
      std::sort(collected_.begin(), collected_.end(),
                [](const FrameSums& a, const FrameSums& b) { return a.index < b.index; });
      for (const FrameSums& sums : collected_) take_(sums);
    });
    over_ = all_at_end_;
    return over_;
  }

  // Whether the ranks have agreed to finish, with or without an error.
  bool over() const { return over_; }

 private:
  static constexpr std::int64_t most_frames = 16;
  struct Header {
    std::int64_t frames, rows, columns, at_end;
  };

  // Sends all waiting sums to rank 0.
  void collect(bool at_end) {
    Header mine{std::ssize(waiting_), 0, 0, at_end ? 1 : 0};
    if (!waiting_.empty())
      mine = {mine.frames, waiting_[0].sums.rows(), waiting_[0].sums.cols(), mine.at_end};
    std::vector<Header> headers(static_cast<std::size_t>(ranks_.size()));
    MPI_Allgather(&mine, 4, MPI_INT64_T, headers.data(), 4, MPI_INT64_T, MPI_COMM_WORLD);
    all_at_end_ = std::all_of(headers.begin(), headers.end(), [](const Header& h) { return h.at_end != 0; });
    collected_.clear();
    if (!ranks_.first()) {
      send();
    } else {
      collected_ = std::move(waiting_);
      for (int from = 1; from < ranks_.size(); ++from) receive(headers[static_cast<std::size_t>(from)], from);
    }
    waiting_.clear();
  }

  void send() const {
    for (const FrameSums& sums : waiting_) {
      const std::int64_t frame[4] = {sums.index, sums.step, sums.run, sums.walls.size()};
      MPI_Send(frame, 4, MPI_INT64_T, 0, 0, MPI_COMM_WORLD);
      const double numbers[2] = {sums.time, sums.places};
      MPI_Send(numbers, 2, MPI_DOUBLE, 0, 0, MPI_COMM_WORLD);
      MPI_Send(sums.walls.data(), static_cast<int>(sums.walls.size()), MPI_DOUBLE, 0, 0, MPI_COMM_WORLD);
      MPI_Send(sums.sums.data(), static_cast<int>(sums.sums.size()), MPI_DOUBLE, 0, 0, MPI_COMM_WORLD);
    }
  }

  void receive(const Header& header, int from) {
    for (std::int64_t i = 0; i < header.frames; ++i) {
      std::int64_t frame[4] = {};
      MPI_Recv(frame, 4, MPI_INT64_T, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      double numbers[2] = {};
      MPI_Recv(numbers, 2, MPI_DOUBLE, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
      FrameSums sums{frame[0],
                     frame[1],
                     frame[2],
                     numbers[0],
                     numbers[1],
                     Eigen::ArrayXd(frame[3]),
                     Rows(header.rows, header.columns)};
      MPI_Recv(sums.walls.data(), static_cast<int>(sums.walls.size()), MPI_DOUBLE, from, 0, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
      MPI_Recv(sums.sums.data(), static_cast<int>(sums.sums.size()), MPI_DOUBLE, from, 0, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
      collected_.push_back(std::move(sums));
    }
  }

  const Ranks& ranks_;
  const TakeSums& take_;
  std::int64_t most_bytes_;
  std::vector<FrameSums> waiting_;    // of this rank
  std::vector<FrameSums> collected_;  // of all ranks, on rank 0
  bool all_at_end_ = false;
  bool over_ = false;
};

}  // namespace

bool under_mpirun() {
  return environment_number("OMPI_COMM_WORLD_SIZE", 1) > 1;
}

int launched_rank() {
  return under_mpirun() ? environment_number("OMPI_COMM_WORLD_RANK", 0) : 0;
}

Ranks::Ranks() {
  if (!under_mpirun()) return;
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() {
  if (size_ > 1) MPI_Finalize();
}

void Ranks::agree(const std::function<void()>& action) const {
  if (size_ == 1) {
    action();
  } else {
    settle(error_of(action), 0);
  }
}

std::int64_t Ranks::of_first(std::int64_t number) const {
  if (size_ > 1) MPI_Bcast(&number, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  return number;
}

FrameSelection Ranks::own_part(FrameSelection selection) const {
  // A stride beyond all frames selects at most one frame, which is left to rank 0.
  constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max() / 4;
  if (selection.stride > most / size_ || selection.first > most) {
    return rank_ > 0 ? FrameSelection::none() : selection;
  }
  selection.first += rank_ * selection.stride;
  selection.stride *= size_;
  return selection;
}

void Ranks::gather(Notes& notes) const {
  if (size_ == 1) return;
  const std::string own = notes.packed();
  const int length = static_cast<int>(own.size());
  std::vector<int> lengths(static_cast<std::size_t>(size_));
  MPI_Gather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
  std::vector<int> begins(lengths.size());
  std::exclusive_scan(lengths.begin(), lengths.end(), begins.begin(), 0);
  std::string all(static_cast<std::size_t>(begins.back() + lengths.back()), '\0');
  MPI_Gatherv(own.data(), length, MPI_CHAR, all.data(), lengths.data(), begins.data(), MPI_CHAR, 0,
              MPI_COMM_WORLD);
  if (first()) notes.add_packed(all);
}

void Ranks::gather_in_order(const std::function<void(const TakeSums&)>& run, const TakeSums& take,
                            std::int64_t most_bytes) const {
  if (size_ == 1) {
    run(take);
    return;
  }
  Rounds rounds(*this, take, most_bytes);
  const auto own = error_of([&] { run([&](const FrameSums& sums) { rounds.add(sums); }); });
  if (own && rounds.over()) throw Error(*own);
  while (!rounds.exchange(own, true)) {
  }
}

}  // namespace mikromakro
