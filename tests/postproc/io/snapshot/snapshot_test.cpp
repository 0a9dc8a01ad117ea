// SPDX-License-Identifier: GPL-2.0-or-later
// Frames through HDF5 snapshots and back.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include "io/frames/frame_stream.h"
#include "io/snapshot/snapshot_reader.h"
#include "io/snapshot/snapshot_writer.h"
#include "text_file.h"

namespace mikromakro {
namespace {

const std::string header = "\nITEM: BOX BOUNDS pp ff ff\n-1 3.5\n0 2\n0 0\nITEM: ATOMS id type x y radius\n";

// Three frames of 2, 3 and 1 discs: the number grows and shrinks.
std::string dump() {
  return "ITEM: TIMESTEP\n1\nITEM: NUMBER OF ATOMS\n2" + header + "5 1 0.1 0.2 0.3\n9 2 1e-17 2 0.7\n" +
         "ITEM: TIMESTEP\n4\nITEM: NUMBER OF ATOMS\n3" + header +
         "5 1 0.3 0.2 0.3\n9 2 1 2 0.7\n1 1 3 3 3\n" + "ITEM: TIMESTEP\n9\nITEM: NUMBER OF ATOMS\n1" +
         header + "9 2 0.333333333333333315 2 0.7\n";
}

void convert(const FrameSource& source, const std::string& to) {
  FrameStream stream(source);
  SnapshotWriter writer(to, "test 1", 0);
  Frame frame;
  while (stream.next(frame)) writer.add(stream.raw(), frame.particles);
  writer.close();
}

TEST(Snapshots, GiveBackEveryBitOfFramesOfAnySize) {
  const Folder folder;
  FrameSource text;
  text.particle_files = {folder.write("p", dump())};
  convert(text, folder.path("s.h5"));
  FrameSource snapshots;
  snapshots.snapshot_files = {folder.path("s.h5")};
  FrameStream expected_stream(text);
  FrameStream stream(snapshots);
  Frame expected;
  Frame frame;
  int frames = 0;
  for (; expected_stream.next(expected); ++frames) {
    ASSERT_TRUE(stream.next(frame));
    EXPECT_EQ(frame.step, expected.step);
    EXPECT_EQ(frame.box.low, expected.box.low);
    EXPECT_EQ(frame.box.high, expected.box.high);
    EXPECT_EQ(frame.box.periodic, expected.box.periodic);
    ASSERT_EQ(frame.particles.size(), expected.particles.size());
    for (std::size_t i = 0; i < frame.particles.size(); ++i) {
      EXPECT_EQ(frame.particles[i].id, expected.particles[i].id);
      EXPECT_EQ(frame.particles[i].type, expected.particles[i].type);
      EXPECT_EQ(frame.particles[i].position, expected.particles[i].position);
      EXPECT_EQ(frame.particles[i].radius, expected.particles[i].radius);
    }
  }
  EXPECT_FALSE(stream.next(frame));
  EXPECT_EQ(frames, 3);
}

// So that what is found in damaged files is found again.
TEST(Snapshots, AreTheSameBytesAtAnyTime) {
  const Folder folder;
  FrameSource text;
  text.particle_files = {folder.write("p", dump())};
  convert(text, folder.path("now.h5"));
  // The library's times are whole seconds.
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));
  convert(text, folder.path("later.h5"));
  EXPECT_EQ(read_text(folder.path("now.h5")), read_text(folder.path("later.h5")));
}

// For the progress of long work: a file counts by the part of its frames that were read.
TEST(Snapshots, BytesReadGrowWithTheFrames) {
  const Folder folder;
  FrameSource text, snapshots;
  text.particle_files = {folder.write("p", dump())};
  convert(text, folder.path("s.h5"));
  snapshots.snapshot_files = {folder.path("s.h5")};
  const auto size = static_cast<double>(std::filesystem::file_size(folder.path("s.h5")));
  FrameStream stream(snapshots);
  Frame frame;
  for (const double part : {1.0 / 3, 2.0 / 3, 1.0}) {
    ASSERT_TRUE(stream.next(frame));
    EXPECT_NEAR(static_cast<double>(stream.bytes_read()), part * size, 1);
  }
  EXPECT_FALSE(stream.next(frame));
  EXPECT_EQ(static_cast<double>(stream.bytes_read()), size);
}

TEST(Snapshots, ColumnsThatAreMissingAreNamed) {
  const Folder folder;
  FrameSource text;
  text.particle_files = {folder.write("p", dump())};
  convert(text, folder.path("s.h5"));
  FrameSource snapshots;
  snapshots.snapshot_files = {folder.path("s.h5")};
  snapshots.particles_needed = column_set(ParticleColumn::mass);
  Frame frame;
  try {
    FrameStream(snapshots).next(frame);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()),
              folder.path("s.h5") + ": columns are missing; expected mass, got only id type x y radius");
  }
}

// A flipped bit in the numbers is found by the chunk's sum.
TEST(Snapshots, AFlippedBitIsAnError) {
  const Folder folder;
  FrameSource text;
  text.particle_files = {folder.write("p", dump())};
  convert(text, folder.path("s.h5"));
  std::string bytes = read_text(folder.path("s.h5"));
  const double radius = 0.7;
  const std::size_t at = bytes.find(std::string(reinterpret_cast<const char*>(&radius), sizeof radius));
  ASSERT_NE(at, std::string::npos);
  bytes[at] = static_cast<char>(bytes[at] ^ 1);
  FrameSource snapshots;
  snapshots.snapshot_files = {folder.write("t.h5", bytes)};
  FrameStream stream(snapshots);
  Frame frame;
  EXPECT_THROW(while (stream.next(frame)){}, Error);
}

// More rows than are unpacked at a time: discs 1 to 700, contacts of each with the next.
RawFrame long_frame() {
  RawFrame raw;
  raw.box = {{0, 0}, {800, 2}, {false, false}};
  raw.particles_given =
      column_set(ParticleColumn::id, ParticleColumn::x, ParticleColumn::y, ParticleColumn::radius);
  for (int id = 1; id <= 700; ++id) {
    Particle particle;
    particle.id = id;
    particle.position = {id, 1};
    particle.radius = 0.5 + 1e-4 * id;
    raw.particles.push_back(particle);
  }
  raw.with_contacts = true;
  raw.contacts.given = column_set(ContactColumn::id1, ContactColumn::id2, ContactColumn::fn);
  for (int id = 1; id < 700; ++id) {
    ContactRow row{};
    row.value.fill(not_given);
    row.value[static_cast<std::size_t>(ContactColumn::id1)] = id;
    row.value[static_cast<std::size_t>(ContactColumn::id2)] = id + 1;
    row.value[static_cast<std::size_t>(ContactColumn::fn)] = 0.25 * id;
    raw.contacts.rows.push_back(row);
  }
  return raw;
}

// The rows as they come back.
RawFrame through_file(const RawFrame& raw, const std::string& name) {
  SnapshotWriter writer(name, "test 1", 0);
  writer.add(raw, raw.particles);
  writer.close();
  SnapshotReader reader({name}, {});
  std::int64_t step = 0;
  EXPECT_TRUE(reader.next(step));
  RawFrame back;
  reader.take()(back);
  return back;
}

TEST(Snapshots, GiveBackEveryRowOfALongFrame) {
  const Folder folder;
  const RawFrame raw = long_frame();
  const RawFrame back = through_file(raw, folder.path("s.h5"));
  ASSERT_EQ(back.particles.size(), raw.particles.size());
  for (std::size_t i = 0; i < raw.particles.size(); ++i) {
    EXPECT_EQ(back.particles[i].id, raw.particles[i].id);
    EXPECT_EQ(back.particles[i].position, raw.particles[i].position);
    EXPECT_EQ(back.particles[i].radius, raw.particles[i].radius);
  }
  ASSERT_EQ(back.contacts.rows.size(), raw.contacts.rows.size());
  for (std::size_t i = 0; i < raw.contacts.rows.size(); ++i)
    for (const ContactColumn column : {ContactColumn::id1, ContactColumn::id2, ContactColumn::fn})
      EXPECT_EQ(back.contacts.rows[i][column], raw.contacts.rows[i][column]);
}

TEST(Snapshots, NumbersThatAreNotFiniteAreNamedByTheirRow) {
  const Folder folder;
  const auto message = [&](const RawFrame& raw, const std::string& name) -> std::string {
    try {
      through_file(raw, folder.path(name));
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  for (const int row : {1, 256, 257, 512, 699}) {
    RawFrame raw = long_frame();
    raw.particles[static_cast<std::size_t>(row) - 1].position.y() = INFINITY;
    EXPECT_EQ(message(raw, "p.h5"), folder.path("p.h5") + fmt::format(":frame 0:{}: not a finite number; "
                                                                      "expected a finite number, got inf",
                                                                      row));
    raw = long_frame();
    raw.contacts.rows[static_cast<std::size_t>(row) - 1].value[static_cast<std::size_t>(ContactColumn::fn)] =
        NAN;
    EXPECT_EQ(message(raw, "c.h5"), folder.path("c.h5") + fmt::format(":frame 0:{}: not a finite number; "
                                                                      "expected a finite number, got nan",
                                                                      row));
  }
}

// The force is there twice, as fx fy and as fn ft; only one of them is needed.
TEST(Snapshots, ForcesThatContradictThemselvesAreAnError) {
  const Folder folder;
  RawFrame raw = long_frame();
  raw.contacts.given |= column_set(ContactColumn::fx, ContactColumn::fy, ContactColumn::ft);
  for (ContactRow& row : raw.contacts.rows) {
    row.value[static_cast<std::size_t>(ContactColumn::fx)] = -row[ContactColumn::fn];
    row.value[static_cast<std::size_t>(ContactColumn::fy)] = 2;
    row.value[static_cast<std::size_t>(ContactColumn::ft)] = 2;
  }
  const auto read = [&](const std::string& name) {
    SnapshotWriter writer(folder.path(name), "test 1", 0);
    writer.add(raw, raw.particles);
    writer.close();
    FrameSource source;
    source.snapshot_files = {folder.path(name)};
    source.contacts_needed = column_set(ContactColumn::fx, ContactColumn::fy);
    FrameStream stream(source);
    Frame frame;
    return stream.next(frame);
  };
  EXPECT_TRUE(read("right.h5"));
  raw.contacts.rows[600].value[static_cast<std::size_t>(ContactColumn::fx)] *= -1;
  EXPECT_THROW(read("wrong.h5"), Error);
}

}  // namespace
}  // namespace mikromakro
