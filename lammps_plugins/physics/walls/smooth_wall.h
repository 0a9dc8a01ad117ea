// SPDX-License-Identifier: GPL-2.0-or-later
// Smooth walls, flat or circular, and their contact with a disc under the disc-disc law (contact_law.h). The
// disc is particle 1, the wall is particle 2 with infinite mass.
//
//   normal         from the disc's centre to the nearest point of the wall
//   contact point  that nearest point: the wall is rigid, the disc alone deforms
//   overlap        a - distance of the centre from the wall
//   lever arm      a - overlap, the distance of the centre from the wall. The reaction on the wall acts at
//                  the same point, so angular momentum is conserved
//   v_n, v_t       as in contact_law.h, relative to the velocity of the wall at the contact point
#pragma once

#include <cmath>

#include "physics/contact/contact_law.h"
#include "physics/contact/spring_step.h"
#include "physics/math/plane_vector.h"

namespace mikromakro::physics {

enum class WallShape {
  flat,
  circle_around,  // the discs are inside the circle
  circle_within   // the discs are outside the circle
};

/// A wall at one time.
struct SmoothWall {
  WallShape shape = WallShape::flat;
  PlaneVector point;             // flat: any point of the surface; circle: the centre (m)
  PlaneVector outward;           // flat: unit vector away from the discs
  double radius = 0.0;           // circle: of the surface (m)
  PlaneVector velocity;          // of the point (m/s)
  double rotation_rate = 0.0;    // about the point (1/s), counter-clockwise positive
  double radial_velocity = 0.0;  // circle: dR/dt (m/s)

  bool operator==(const SmoothWall&) const = default;
};

/// The point of a wall nearest to the centre of a disc.
struct WallPoint {
  PlaneVector normal;  // from the disc to the wall
  double distance;     // of the centre from the wall (m), negative beyond it
  PlaneVector place;   // (m)
};

inline WallPoint nearest_point(const SmoothWall& wall, const PlaneVector& centre) {
  const double x = centre.x - wall.point.x, y = centre.y - wall.point.y;
  if (wall.shape == WallShape::flat) {
    const double distance = -(x * wall.outward.x + y * wall.outward.y);
    return {
        wall.outward, distance, {centre.x + distance * wall.outward.x, centre.y + distance * wall.outward.y}};
  }
  const double from_centre = std::hypot(x, y);
  // At the centre all points of the circle are equally near; pick one.
  const PlaneVector radial =
      from_centre > 0 ? PlaneVector{x / from_centre, y / from_centre} : PlaneVector{1, 0};
  const PlaneVector place{wall.point.x + wall.radius * radial.x, wall.point.y + wall.radius * radial.y};
  if (wall.shape == WallShape::circle_around) return {radial, wall.radius - from_centre, place};
  return {{-radial.x, -radial.y}, from_centre - wall.radius, place};
}

/// 1/R of a circle (1/m), negative if the discs are inside; 0 for a flat wall.
inline double curvature(const SmoothWall& wall) {
  if (wall.shape == WallShape::flat) return 0.0;
  return (wall.shape == WallShape::circle_around ? -1 : 1) / wall.radius;
}

/// Reduced radius a R/(a + R) for Hertz's law (m).
constexpr double reduced_radius_at(double curvature, double disc_radius) {
  return disc_radius / (1 + disc_radius * curvature);
}

/// Material velocity of the wall at a point of its surface (m/s).
inline PlaneVector velocity_at(const SmoothWall& wall, const PlaneVector& place) {
  const double x = place.x - wall.point.x, y = place.y - wall.point.y;
  PlaneVector v{wall.velocity.x - wall.rotation_rate * y, wall.velocity.y + wall.rotation_rate * x};
  if (wall.shape != WallShape::flat) {
    v.x += wall.radial_velocity * x / wall.radius;
    v.y += wall.radial_velocity * y / wall.radius;
  }
  return v;
}

/// Upper bound on the displacement of the wall's surface along its normal (m).
inline double displacement(const SmoothWall& from, const SmoothWall& to) {
  const double x = to.point.x - from.point.x, y = to.point.y - from.point.y;
  if (to.shape == WallShape::flat) return std::abs(x * to.outward.x + y * to.outward.y);
  return std::hypot(x, y) + std::abs(to.radius - from.radius);
}

struct MovingDisc {
  PlaneVector position;  // m
  PlaneVector velocity;  // m/s
  double spin;           // 1/s
  double radius;         // m
};

/// Overlap and relative velocities of a disc at a wall; xi is the spring before this step.
inline ContactState state_at_wall(const SmoothWall& wall, const WallPoint& point, const MovingDisc& disc,
                                  double xi) {
  const PlaneVector v = velocity_at(wall, point.place);
  const double w_x = disc.velocity.x - v.x, w_y = disc.velocity.y - v.y;
  const PlaneVector& n = point.normal;
  return {disc.radius - point.distance, w_x * n.x + w_y * n.y,
          w_y * n.x - w_x * n.y + disc.spin * point.distance, xi};
}

/// Contact history of a disc at a wall, for laws with a spring.
struct WallSpring {
  double xi = 0.0;         // m
  double slip_rate = 0.0;  // at the middle of the last step (m/s)
  bool touching = false;
};

/// Force on a disc in contact with a wall; updates the spring as the pair loop does.
template <Effects effects>
ContactForce wall_contact_force(const ContactParameters& parameters, const ContactState& state,
                                const StepOfSlip& step, WallSpring& spring) {
  if constexpr (!effects.spring()) {
    return contact_force<effects>(parameters, state, 0.0);
  } else {
    const auto [rate, slip] = spring.touching ? step_of_old_contact(spring.slip_rate, state.v_t, step)
                                              : step_of_new_contact(state, step);
    const ContactForce force = contact_force<effects>(parameters, state, slip);
    if (step.dt > 0) {
      spring = {force.xi, rate, true};
    } else if (!spring.touching) {
      spring = {0.0, rate, true};
    }
    return force;
  }
}

/// Load of the discs on a wall.
struct WallLoad {
  double pressing = 0.0;  // sum of f_n (N), > 0 pushes the wall away from the discs
  PlaneVector force;      // on the wall (N)
  double torque = 0.0;    // on the wall about its point (N m), counter-clockwise positive

  void add(const SmoothWall& wall, const WallPoint& at, double f_n, const PlaneVector& force_on_disc) {
    pressing += f_n;
    force.x -= force_on_disc.x;
    force.y -= force_on_disc.y;
    torque -= (at.place.x - wall.point.x) * force_on_disc.y - (at.place.y - wall.point.y) * force_on_disc.x;
  }
};

}  // namespace mikromakro::physics
