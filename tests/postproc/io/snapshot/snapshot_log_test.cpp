// SPDX-License-Identifier: GPL-2.0-or-later
// The snapshot file of a run: continued, read meanwhile, and after its writer was killed at any moment.
#include "io/snapshot/snapshot_log.h"

#include <dlfcn.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <random>

#include "child.h"
#include "io/snapshot/snapshot_reader.h"
#include "text_file.h"

namespace mikromakro {
namespace {

/// Any numbers, different in every place of every frame, the same whenever they are asked for; the numbers of
/// discs and contacts go up and down.
RawFrame frame_at(std::int64_t step) {
  std::mt19937 generator(static_cast<unsigned>(step));
  const auto number = [&] { return static_cast<double>(generator()) / 7; };
  RawFrame frame;
  frame.step = step;
  frame.time = 0.1 * static_cast<double>(step);
  frame.box = {{0, 0}, {number(), number()}, {true, false}};
  for (int i = 0; i < 3000 + step % 5; ++i)
    frame.particles.push_back(
        {i + 1, 1 + i % 2, {number(), number()}, 1.0 + i % 2, {number(), number()}, number(), number()});
  frame.particles_given = (ColumnSet{1} << static_cast<unsigned>(ParticleColumn::count)) - 1;
  frame.with_contacts = true;
  frame.contacts.given = (ColumnSet{1} << static_cast<unsigned>(contact_disc_columns)) - 1;
  for (int i = 0; i < 1500 + 100 * (step % 7); ++i) {
    ContactRow row{};
    row.value.fill(not_given);
    for (std::size_t slot = 0; slot < contact_disc_columns; ++slot) row.value[slot] = number();
    row.value[0] = 1 + i, row.value[1] = 2 + i, row.value[6] = 0.6, row.value[7] = 0.8;
    frame.contacts.rows.push_back(row);
  }
  frame.walls = {{"cell", "couette/2d", {number(), number()}}};
  return frame;
}

SnapshotParameters parameters(double k_n = 352.1) {
  return {{{"effects", {"normal spring", "friction"}}}, {{"kn", "N/m", {2, 2}, {k_n, 1, 1, 2}}}};
}

void expect_equal(const RawFrame& frame, const RawFrame& expected) {
  ASSERT_EQ(frame.particles.size(), expected.particles.size());
  for (std::size_t i = 0; i < frame.particles.size(); ++i) {
    const Particle &one = frame.particles[i], &other = expected.particles[i];
    ASSERT_TRUE(one.id == other.id && one.type == other.type && one.position == other.position &&
                one.radius == other.radius && one.velocity == other.velocity && one.spin == other.spin &&
                one.mass == other.mass)
        << "disc " << i << " of step " << expected.step;
  }
  ASSERT_EQ(frame.contacts.rows.size(), expected.contacts.rows.size());
  for (std::size_t i = 0; i < frame.contacts.rows.size(); ++i)
    for (std::size_t slot = 0; slot < contact_disc_columns; ++slot)
      // Ids of discs are whole numbers.
      ASSERT_EQ(frame.contacts.rows[i].value[slot], expected.contacts.rows[i].value[slot])
          << "contact " << i << " of step " << expected.step;
}

/// Reads the file, compares its frames (from the given one on) with what was written and gives the steps.
std::vector<std::int64_t> steps_of(const std::string& file, std::size_t first_compared = 0) {
  SnapshotReader reader({file}, {});
  std::vector<std::int64_t> steps;
  std::int64_t step = 0;
  while (reader.next(step)) {
    steps.push_back(step);
    if (steps.size() <= first_compared) continue;
    RawFrame frame;
    reader.take()(frame);
    expect_equal(frame, frame_at(step));
  }
  return steps;
}

std::vector<std::int64_t> from_to(std::int64_t first, std::int64_t last) {
  std::vector<std::int64_t> steps;
  for (std::int64_t step = first; step <= last; ++step) steps.push_back(step);
  return steps;
}

TEST(SnapshotLog, AppendsAndNeverTwiceTheSameStep) {
  const Folder folder;
  SnapshotLog log(folder.path("s.h5"), "test 1", parameters());
  for (const std::int64_t step : {0, 1, 1, 2, 2, 3}) log.add(frame_at(step));
  EXPECT_EQ(steps_of(folder.path("s.h5")), from_to(0, 3));
  const Hdf5File file = Hdf5File::open(folder.path("s.h5"));
  std::vector<double> walls(8);
  file.dataset("/walls/cell/value").read<double>({{0, 0}, {4, 2}}, walls);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(walls[2 * i + 1], frame_at(i).walls[0].numbers[1]);
  std::vector<double> time(4);
  file.dataset("/contacts/time").read<double>({{0}, {4}}, time);
  EXPECT_EQ(time, (std::vector<double>{0, 0.1, 0.1 * 2, 0.1 * 3}));
  EXPECT_THROW(log.add(frame_at(1)), Error);
}

TEST(SnapshotLog, ReplacesAnOldFileUnlessItIsContinued) {
  const Folder folder;
  // Other steps in each run, later or earlier ones: a file that stays, or that is appended to, shows.
  for (const std::int64_t first : {5, 8, 1}) {
    SnapshotLog log(folder.path("s.h5"), "test 1", parameters());
    log.add(frame_at(first));
    log.add(frame_at(first + 1));
    EXPECT_EQ(steps_of(folder.path("s.h5")), from_to(first, first + 1));
  }
}

// From a restart at step 4, the frames of steps 5 to 8 are written anew, with less in them than was there.
TEST(SnapshotLog, FramesAfterARestartReplaceThoseBeforeIt) {
  const Folder folder;
  {
    SnapshotLog log(folder.path("s.h5"), "test 1", parameters());
    for (std::int64_t step = 0; step <= 8; ++step) log.add(frame_at(step));
  }
  SnapshotLog log(folder.path("s.h5"), "test 1", parameters());
  EXPECT_EQ(log.resume(frame_at(4)), 4);
  EXPECT_EQ(steps_of(folder.path("s.h5")), from_to(0, 4));
  for (const std::int64_t step : {4, 7, 10, 15}) log.add(frame_at(step));
  EXPECT_EQ(steps_of(folder.path("s.h5")), (std::vector<std::int64_t>{0, 1, 2, 3, 4, 7, 10, 15}));
}

TEST(SnapshotLog, WithoutAFileAContinuedOneBegins) {
  const Folder folder;
  SnapshotLog log(folder.path("s.h5"), "test 1", parameters());
  EXPECT_EQ(log.resume(frame_at(3)), 0);
  log.add(frame_at(3));
  EXPECT_EQ(steps_of(folder.path("s.h5")), from_to(3, 3));
}

std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(SnapshotLog, AnotherSystemIsAnError) {
  const Folder folder;
  const std::string file = folder.path("s.h5");
  SnapshotLog(file, "test 1", parameters()).add(frame_at(0));
  const auto error_with = [&](const SnapshotParameters& other, const RawFrame& present) {
    return error_of([&] { SnapshotLog(file, "test 1", other).resume(present); });
  };
  EXPECT_EQ(error_with(parameters(400), frame_at(1)),
            file + ": belongs to another system, kn differs; expected 352.1 1 1 2, got 400 1 1 2");
  RawFrame larger = frame_at(1);
  larger.particles[3].radius = 2.5;
  EXPECT_EQ(error_with(parameters(), larger), file +
                                                  ": belongs to another system, disc 4 differs; expected "
                                                  "type 2 and radius 2 m, got type 2 and radius 2.5 m");
  RawFrame others = frame_at(1);
  for (Particle& disc : others.particles) disc.id += 10000;
  EXPECT_EQ(error_with(parameters(), others),
            file + ": belongs to another system; expected discs that the file has, got none of them");
  RawFrame other_box = frame_at(0);
  other_box.step = -1;  // all frames would be dropped
  other_box.box.periodic = {true, true};
  EXPECT_NE(error_with(parameters(), other_box).find("the boundaries change"), std::string::npos);
  EXPECT_EQ(steps_of(file), from_to(0, 0));
}

TEST(SnapshotLog, NoticesAnotherWriter) {
  const Folder folder;
  SnapshotLog one(folder.path("s.h5"), "test 1", parameters());
  one.add(frame_at(0));
  SnapshotLog two(folder.path("s.h5"), "test 1", parameters());
  two.resume(frame_at(0));
  two.add(frame_at(1));
  EXPECT_EQ(error_of([&] { one.add(frame_at(2)); }),
            folder.path("s.h5") + ": another program writes to the same file; expected 1 frames, got 2");
}

/// Whether the file could always be read until it had so many frames, none of which ever went away.
bool read_until(const std::string& file, std::size_t frames) {
  try {
    for (std::size_t seen = 0; seen < frames;) {
      const auto steps = steps_of(file, seen);
      if (steps.size() < seen) return false;
      seen = steps.size();
    }
    return !testing::Test::HasFailure();
  } catch (const Error& error) {
    std::printf("%s\n", error.what());
    std::fflush(stdout);
    return false;
  }
}

// A reader has the file open all the time, as a notebook might, and another one reads it again and again.
TEST(SnapshotLog, IsReadWhileItIsWritten) {
  const Folder folder;
  const std::string file = folder.path("s.h5");
  constexpr std::int64_t last = 30;
  SnapshotLog log(file, "test 1", parameters());
  log.add(frame_at(0));
  const Child holder([&] {
    const Hdf5File held = Hdf5File::open(file);
    pause();
    return 0;
  });
  Child reader([&] { return read_until(file, last + 1) ? 0 : 1; });
  for (std::int64_t step = 1; step <= last; ++step) log.add(frame_at(step));
  EXPECT_EQ(reader.exit_code(), 0);
}

// HDF5 changes files by pwrite and ftruncate; those of this program, below, come before the C library's. Each
// change counts down, and the process is killed at the one that would be number 0: before it, or where it
// reaches over the end of a page of the file, after that, as the system may do.
struct KillPoint {
  long change = -1;  // never
  bool within = false;
};
KillPoint kill_point;
constexpr off_t page = 4096;

/// The bytes of a change that are written before the kill; all that are wanted where there is none.
size_t bytes_before_kill(size_t wanted, off_t at) {
  if (kill_point.change < 0 || --kill_point.change >= 0) return wanted;
  const auto in_page = static_cast<size_t>(page - at % page);
  return kill_point.within && in_page < wanted ? in_page : 0;
}

/// Continues the file by two frames in a process that is killed at the given
/// change of the file. Whether it came to its end before.
bool continued(const std::string& file, const KillPoint& at) {
  const std::int64_t last = steps_of(file).back();
  Child writer([&] {
    kill_point = at;
    SnapshotLog log(file, "test 1", parameters());
    log.resume(frame_at(last));
    for (const std::int64_t step : {last + 1, last + 2}) log.add(frame_at(step));
    return 0;
  });
  const int code = writer.exit_code();
  EXPECT_LE(code, 0) << "change " << at.change;
  const auto now = steps_of(file);
  EXPECT_EQ(now, from_to(0, std::ssize(now) - 1));
  EXPECT_GE(now.back(), last);
  return code == 0;
}

// Twice in succession, so that the second kill falls into what mends the file after the first one too.
TEST(SnapshotLog, CompleteFramesSurviveKillsAtEveryChangeOfTheFile) {
  const Folder folder;
  const std::string file = folder.path("s.h5");
  long changes = 0;
  for (bool over = false; !over && !HasFailure(); ++changes) {
    std::filesystem::remove(file);
    SnapshotLog(file, "test 1", parameters()).add(frame_at(0));
    over = continued(file, {changes, changes % 2 == 0});
    continued(file, {7 * changes % 290, true});
    steps_of(file);
  }
  EXPECT_GT(changes, 100);
  EXPECT_TRUE(continued(file, {}));
}

}  // namespace
}  // namespace mikromakro

extern "C" ssize_t pwrite(int file, const void* bytes, size_t wanted, off_t at) {
  using Write = ssize_t (*)(int, const void*, size_t, off_t);
  static const auto write = reinterpret_cast<Write>(dlsym(RTLD_NEXT, "pwrite"));
  const size_t size = mikromakro::bytes_before_kill(wanted, at);
  const ssize_t written = write(file, bytes, size, at);
  if (size < wanted) kill(getpid(), SIGKILL);
  return written;
}

extern "C" int ftruncate(int file, off_t length) noexcept {
  using Truncate = int (*)(int, off_t);
  static const auto truncate = reinterpret_cast<Truncate>(dlsym(RTLD_NEXT, "ftruncate"));
  if (mikromakro::bytes_before_kill(1, 0) == 0) kill(getpid(), SIGKILL);
  return truncate(file, length);
}

// What an HDF5 built for large files calls; the same numbers on 64 bits.
extern "C" ssize_t pwrite64(int file, const void* bytes, size_t wanted, off64_t at) {
  return pwrite(file, bytes, wanted, at);
}
extern "C" int ftruncate64(int file, off64_t length) noexcept {
  return ftruncate(file, length);
}
