// SPDX-License-Identifier: GPL-2.0-or-later
// The two discs, the fixed disc and the wall of particles.dump and contacts.dump, as MercuryDPM writes them.
#include <gtest/gtest.h>

#include <algorithm>

#include "io/frames/frame_stream.h"
#include "text_file.h"

namespace mikromakro {
namespace {

const std::string good = TEST_DATA "/good/";

std::vector<Frame> read(const std::string& particles, const std::string& contacts) {
  FrameSource source;
  source.particle_files = {particles};
  if (!contacts.empty()) source.contact_files = {contacts};
  FrameStream stream(source);
  std::vector<Frame> frames;
  for (Frame frame; stream.next(frame);) frames.push_back(frame);
  return frames;
}

class MercuryFiles : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Formats, MercuryFiles, testing::Values("mercury.data", "mercury_3d.data"),
                         [](const auto& tested) {
                           return tested.param == "mercury.data" ? "plane" : "space";
                         });

TEST_P(MercuryFiles, GiveDiscsByRowSpeciesAndCounterClockwiseSpin) {
  const auto frames = read(good + GetParam(), "");
  ASSERT_EQ(frames.size(), 2U);
  EXPECT_EQ(frames[0].step, 0);
  EXPECT_EQ(frames[1].step, 1);
  EXPECT_EQ(frames[0].box.low, Eigen::Vector2d(-5, -5));
  EXPECT_EQ(frames[0].box.high, Eigen::Vector2d(5, 5));
  ASSERT_EQ(frames[1].particles.size(), 4U);
  const Particle& first = frames[1].particles[0];
  EXPECT_EQ(first.id, 1);
  EXPECT_EQ(first.type, 1);
  EXPECT_EQ(first.position, Eigen::Vector2d(1, 0));
  EXPECT_EQ(first.velocity, Eigen::Vector2d(0, 3));
  EXPECT_EQ(first.radius, 0.5);
  EXPECT_EQ(first.spin, 0.5);
  EXPECT_EQ(frames[1].particles[3].type, 2);
}

TEST_P(MercuryFiles, GiveEachContactOnceWithTheForceOnItsFirstDisc) {
  const auto frames = read(good + GetParam(), good + "mercury.fstat");
  ASSERT_EQ(frames.size(), 2U);
  const auto& contacts = frames[0].contacts;
  ASSERT_EQ(contacts.size(), 3U);
  // 10 N push disc 1 to the left, 1 N up.
  EXPECT_EQ(contacts[0].id1, 1);
  EXPECT_EQ(contacts[0].id2, 2);
  EXPECT_EQ(contacts[0].normal, Eigen::Vector2d(1, 0));
  EXPECT_EQ(contacts[0].force, Eigen::Vector2d(-10, 1));
  EXPECT_EQ(contacts[0].overlap, 0.1);
  // The fixed disc has no row of its own; it pushes disc 2 to the left.
  EXPECT_EQ(contacts[1].id1, 2);
  EXPECT_EQ(contacts[1].id2, 4);
  EXPECT_EQ(contacts[1].normal, Eigen::Vector2d(1, 0));
  EXPECT_EQ(contacts[1].force, Eigen::Vector2d(-5, 0));
  // The wall at the left pushes disc 1 to the right.
  EXPECT_TRUE(contacts[2].with_wall());
  EXPECT_EQ(contacts[2].id2, -101);
  EXPECT_EQ(contacts[2].normal, Eigen::Vector2d(-1, 0));
  EXPECT_EQ(contacts[2].force, Eigen::Vector2d(2, 0));
}

// A tangential spring of 0.01 m under a tangential force of 1 N along t = (-n_y, n_x) = (0, 1): xi is against
// it.
TEST(MercurySprings, AreAgainstTheTangentialForce) {
  const Folder folder;
  std::string text = read_text(good + "mercury.fstat");
  for (std::size_t at = 0; (at = text.find(" 0.1 0 10 1 ", at)) != std::string::npos; ++at)
    text.replace(at, 12, " 0.1 0.01 10 1 ");
  const auto frames = read(good + "mercury.data", folder.write("f", text));
  EXPECT_EQ(frames[0].contacts[0].spring, -0.01);
  EXPECT_EQ(frames[0].contacts[1].spring, 0);
}

// Radii of interaction may be larger than radii, so that those of another run are told and not refused.
TEST(MercuryRadii, OfAnotherRunAreTold) {
  const Folder folder;
  std::string text = read_text(good + "mercury.fstat");
  const auto notes = [&] {
    FrameSource source;
    source.particle_files = {good + "mercury.data"};
    source.contact_files = {folder.write("f.fstat", text)};
    Frame frame;
    FrameStream(source).next(frame);
    return source.notes->lines();
  };
  for (const std::string& line : notes()) EXPECT_EQ(line.find("radii"), std::string::npos) << line;
  text.replace(text.find("# 0.125 0.5 "), 12, "# 0.125 0.501 ");
  const auto told = notes();
  EXPECT_TRUE(std::any_of(told.begin(), told.end(), [](const std::string& line) {
    return line.find("the radii in the header are not those of the particles") != std::string::npos;
  }));
}

// m = rho h pi a^2, and one line where it is asked for and cannot be known.
TEST(MercuryMasses, AreThoseOfTheDensity) {
  FrameSource source;
  source.particle_files = {good + "mercury.data"};
  source.particles_needed = column_set(ParticleColumn::mass);
  Frame frame;
  try {
    FrameStream(source).next(frame);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), good +
                                             "mercury.data: MercuryDPM's files give no masses; expected "
                                             "--density (kg/m^2) or fields without mass, got neither");
  }
  source.density = 6;
  FrameStream(source).next(frame);
  EXPECT_DOUBLE_EQ(frame.particles[0].mass, 4.71238898038469);  // 6 pi/4
}

}  // namespace
}  // namespace mikromakro
