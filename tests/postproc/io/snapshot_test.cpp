// Frames through HDF5 snapshots and back.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "io/frame_stream.h"
#include "io/snapshot_reader.h"
#include "io/snapshot_writer.h"
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

}  // namespace
}  // namespace mikromakro
