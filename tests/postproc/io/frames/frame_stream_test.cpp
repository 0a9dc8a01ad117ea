// SPDX-License-Identifier: GPL-2.0-or-later
#include "io/frames/frame_stream.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>

#include "model/error.h"
#include "text_file.h"

namespace mikromakro {
namespace {

std::string header(std::int64_t step, const std::string& label, int rows, const std::string& columns) {
  return std::string("ITEM: TIMESTEP\n") + std::to_string(step) + "\nITEM: NUMBER OF " + label + "\n" +
         std::to_string(rows) + "\nITEM: BOX BOUNDS pp ff ff\n-5 5\n-6 6\n-1 1\nITEM: " + label + " " +
         columns + "\n";
}

// Ids with a gap, not in order, columns in another order than ours, one that we do not use.
std::string particles(std::int64_t step) {
  return header(step, "ATOMS", 2, "radius z x y type id vx vy omegaz mass") +
         "0.5 0 1 2 1 900 0.1 0.2 0.3 4\n0.25 0 1.7 2 2 3 0 -1e-3 0 1 \n";
}

std::string contacts(std::int64_t step) {
  return header(step, "ENTRIES", 1, "id1 id2 nx ny overlap fx fy") + "900 3 1 0 0.05 -7 1\n";
}

std::vector<Frame> read_all(const FrameSource& source) {
  FrameStream stream(source);
  std::vector<Frame> frames;
  Frame frame;
  while (stream.next(frame)) frames.push_back(frame);
  return frames;
}

std::vector<std::int64_t> steps_of(const std::vector<Frame>& frames) {
  std::vector<std::int64_t> steps;
  steps.reserve(frames.size());
  for (const Frame& frame : frames) steps.push_back(frame.step);
  return steps;
}

void expect_the_frame(const Frame& frame) {
  ASSERT_EQ(frame.particles.size(), 2U);
  EXPECT_EQ(frame.particles[0].id, 900);
  EXPECT_EQ(frame.particles[0].position, Eigen::Vector2d(1, 2));
  EXPECT_EQ(frame.particles[0].radius, 0.5);
  EXPECT_EQ(frame.particles[0].spin, 0.3);
  EXPECT_EQ(frame.particles[0].mass, 4);
  EXPECT_EQ(frame.particles[1].type, 2);
  EXPECT_EQ(frame.particles[1].velocity, Eigen::Vector2d(0, -1e-3));
  ASSERT_EQ(frame.contacts.size(), 1U);
  EXPECT_EQ(frame.contacts[0].index1, 0);
  EXPECT_EQ(frame.contacts[0].index2, 1);
  EXPECT_EQ(frame.contacts[0].force, Eigen::Vector2d(-7, 1));
  EXPECT_TRUE(frame.box.periodic[0]);
  EXPECT_FALSE(frame.box.periodic[1]);
  EXPECT_EQ(frame.box.length(), Eigen::Vector2d(10, 12));
}

TEST(FrameStream, ReadsColumnsByNameInAnyOrderAndIdsWithGaps) {
  const Folder folder;
  const auto frames =
      read_all({{folder.write("p", particles(5))}, {folder.write("c", contacts(5))}, {}, {}, 0, 0, {}});
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].step, 5);
  expect_the_frame(frames[0]);
}

TEST(FrameStream, LineEndsOfWindowsAreAccepted) {
  const Folder folder;
  const auto crlf = [](const std::string& text) {
    std::string with_returns;
    for (const char c : text) with_returns.append(c == '\n' ? 2 : 1, c == '\n' ? '\r' : c).back() = c;
    return with_returns;
  };
  const auto frames = read_all(
      {{folder.write("p", crlf(particles(5)))}, {folder.write("c", crlf(contacts(5)))}, {}, {}, 0, 0, {}});
  ASSERT_EQ(frames.size(), 1U);
  expect_the_frame(frames[0]);
}

TEST(FrameStream, CompressedFilesAreKnownByTheirContent) {
  const Folder folder;
  const auto compressed = [&folder](const std::string& name, const std::string& text) {
    gzFile file = gzopen(folder.path(name).c_str(), "wb");
    gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    gzclose(file);
    return folder.path(name);
  };
  const auto frames =
      read_all({{compressed("p", particles(5))}, {compressed("c.dump", contacts(5))}, {}, {}, 0, 0, {}});
  ASSERT_EQ(frames.size(), 1U);
  expect_the_frame(frames[0]);
}

TEST(FrameStream, LinesAcrossBlocksOfTheReaderAreWhole) {
  // 3 MB of frames, so that the 1-MB blocks end within lines.
  const Folder folder;
  std::string text_p;
  std::string text_c;
  const int count = 10000;
  for (int step = 0; step < count; ++step) {
    text_p += particles(step);
    text_c += contacts(step);
  }
  const auto frames = read_all({{folder.write("p", text_p)}, {folder.write("c", text_c)}, {}, {}, 0, 0, {}});
  ASSERT_EQ(frames.size(), static_cast<std::size_t>(count));
  for (const Frame& frame : frames) expect_the_frame(frame);
}

TEST(FrameStream, FilesAreTakenInTheOrderOfTheirSteps) {
  const Folder folder;
  const auto ten = folder.write("p10", particles(10) + particles(20));
  const auto nine = folder.write("p9", particles(9));
  const auto both = folder.write("c", contacts(9) + contacts(10) + contacts(20));
  EXPECT_EQ(steps_of(read_all({{ten, nine}, {both}, {}, {}, 0, 0, {}})),
            (std::vector<std::int64_t>{9, 10, 20}));
}

TEST(FrameStream, FramesAreSelectedByIndexAndByStep) {
  const Folder folder;
  std::string text_p;
  std::string text_c;
  for (int step = 0; step <= 600; step += 100) {
    text_p += particles(step);
    text_c += contacts(step);
  }
  FrameSource source{{folder.write("p", text_p)}, {folder.write("c", text_c)}, {}, {}, 0, 0, {}};
  select_frames("1:5:2", source.selection);
  EXPECT_EQ(steps_of(read_all(source)), (std::vector<std::int64_t>{100, 300, 500}));
  select_steps("200:400", source.selection);
  EXPECT_EQ(steps_of(read_all(source)), (std::vector<std::int64_t>{300}));
  source.selection = {};
  select_frames("5:", source.selection);
  EXPECT_EQ(steps_of(read_all(source)), (std::vector<std::int64_t>{500, 600}));
}

TEST(FrameStream, UnnamedColumnsOfOurComputeAreKnown) {
  const Folder folder;
  std::string names;
  for (int i = 1; i <= 16; ++i) names += std::string("c_cd[") + std::to_string(i) + "] ";
  // id1 id2 x1 y1 x2 y2 nx ny overlap fx fy fn ft xi vn vt
  const auto rows = header(5, "ENTRIES", 1, names) + "900 3 1 2 1.7 2 1 0 0.05 -7 1 7 1 0.25 0 0\n";
  const auto frames =
      read_all({{folder.write("p", particles(5))}, {folder.write("c", rows)}, {}, {}, 0, 0, {}});
  ASSERT_EQ(frames.size(), 1U);
  expect_the_frame(frames[0]);
  EXPECT_EQ(frames[0].contacts[0].overlap, 0.05);
  EXPECT_EQ(frames[0].contacts[0].spring, 0.25);
}

TEST(FrameStream, ParticleColumnsCanBeNamedByTheUser) {
  const Folder folder;
  const auto text = header(5, "ATOMS", 1, "c_a[1] c_a[2] c_a[3] c_a[4] c_a[5]") + "7 0.5 9 1 2\n";
  const auto frames =
      read_all({{folder.write("p", text)}, {}, {"id", "radius", "-", "x", "y"}, {}, 0, 0, {}});
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].particles[0].id, 7);
  EXPECT_EQ(frames[0].particles[0].position, Eigen::Vector2d(1, 2));
}

TEST(FrameStream, WhatIsNotNeededNeedNotBeThere) {
  const Folder folder;
  const FrameSource source{
      {folder.write("p", header(5, "ATOMS", 1, "id x y radius") + "1 0 0 1\n")}, {}, {}, {}, 0, 0, {}};
  const auto frames = read_all(source);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_TRUE(std::isnan(frames[0].particles[0].mass));
  FrameSource needs_mass = source;
  needs_mass.particles_needed = column_set(ParticleColumn::mass);
  EXPECT_THROW(read_all(needs_mass), Error);
}

std::string contacts_with_places(std::int64_t step, double x2) {
  return header(step, "ENTRIES", 1, "id1 id2 x1 y1 x2 y2 nx ny overlap fx fy") + "900 3 1 2 " +
         std::to_string(x2) + " 2 1 0 0.05 -7 1\n";
}

// Steps 0 to 69, of which one has rows that put disc 3 elsewhere.
std::string what_is_said(const FrameSelection& selection, int wrong) {
  const Folder folder;
  std::string discs, rows;
  for (int step = 0; step < 70; ++step) {
    discs += particles(step);
    rows += contacts_with_places(step, step == wrong ? 2.1 : 1.7);
  }
  FrameSource source{{folder.write("p", discs)}, {folder.write("c", rows)}, {}, {}, 0, 0, selection};
  source.contacts_needed = column_set(ContactColumn::fx, ContactColumn::fy, ContactColumn::overlap);
  try {
    read_all(source);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

// Columns that are not needed cost time: they are looked at in frame 0 and every 64th of the selected ones.
TEST(FrameStream, ChecksWhatIsNotNeededNowAndThen) {
  const FrameSelection all;
  EXPECT_EQ(what_is_said(all, -1), "");
  EXPECT_NE(what_is_said(all, 0).find("disc 3 is not where the row says"), std::string::npos);
  EXPECT_NE(what_is_said(all, 64).find("disc 3 is not where the row says"), std::string::npos);
  EXPECT_EQ(what_is_said(all, 63), "");
  FrameSelection later;
  select_frames("7:", later);
  EXPECT_NE(what_is_said(later, 7).find("disc 3 is not where the row says"), std::string::npos);
  FrameSelection by_step;
  select_steps("3:67", by_step);
  EXPECT_NE(what_is_said(by_step, 67).find("disc 3 is not where the row says"), std::string::npos);
}

TEST(FrameStream, BoxesOfOneStepHaveOneBoundary) {
  const Folder folder;
  std::string other = contacts(5);
  other.replace(other.find("pp ff"), 5, "ff ff");
  FrameSource source{{folder.write("p", particles(5))}, {folder.write("c", other)}, {}, {}, 0, 0, {}};
  try {
    read_all(source);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("the box is not that of the particles"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("got -5 5 not periodic"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace mikromakro
