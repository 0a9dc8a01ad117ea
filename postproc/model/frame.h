// SPDX-License-Identifier: GPL-2.0-or-later
// One snapshot in memory: discs and contacts as the averages use them, independent of the file format.
#pragma once

#include <array>
#include <cstdint>
#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

namespace mikromakro {

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// The simulation box in the plane (m); the third dimension of the dumps is ignored.
struct Box {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();
  std::array<bool, 2> periodic = {false, false};
  bool boundaries_known = true;  ///< false: the file does not say which boundaries are periodic
  std::array<bool, 2> wrapped = {false, false};  ///< the box follows the discs: no period, nothing to compare

  Eigen::Vector2d length() const { return high - low; }
  /// For messages.
  const char* boundary(std::size_t axis) const { return periodic[axis] ? "periodic" : "not periodic"; }
};

/// A disc; SI units. Values missing from the dump are nan (type: 0).
struct Particle {
  std::int64_t id = 0;
  int type = 0;
  Eigen::Vector2d position = {not_given, not_given};
  double radius = not_given;
  Eigen::Vector2d velocity = {not_given, not_given};
  double spin = not_given;  ///< omega_z, rad/s, counter-clockwise positive
  double mass = not_given;
};

/// A contact; SI units. The normal points from disc 1 to disc 2, the force acts on disc 1, and overlap > 0 in
/// contact.
struct Contact {
  std::int64_t id1 = 0;
  std::int64_t id2 = 0;  ///< <= 0: a wall
  int index1 = -1;       ///< of disc 1 in Frame::particles
  int index2 = -1;       ///< of disc 2, -1 for a wall
  Eigen::Vector2d normal = {not_given, not_given};
  double overlap = not_given;
  Eigen::Vector2d force = {not_given, not_given};
  double spring = not_given;  ///< slip xi of 1 against 2 along t = (-n_y, n_x)

  bool with_wall() const { return id2 <= 0; }
};

/// State of a wall at one step: the numbers that a fix outputs, under the name of the fix.
struct WallState {
  std::string name;
  std::string style;  ///< defines what the numbers mean
  std::vector<double> numbers;
  bool height_known = true;  ///< false: pressures are forces per length
};

struct Frame {
  std::int64_t step = 0;
  double time = not_given;  ///< s
  std::int64_t index = 0;   ///< among all frames of the input, from 0
  std::int64_t run = 0;     ///< among the runs of the input, from 0
  Box box;
  std::vector<Particle> particles;
  std::vector<Contact> contacts;
  std::vector<WallState> walls = {};  ///< those that were wished for
  bool contacts_known = true;         ///< false: there is no contact file; discs may still touch
};

}  // namespace mikromakro
