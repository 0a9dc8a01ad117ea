// SPDX-License-Identifier: GPL-2.0-or-later
// What a time step costs in accuracy, contact by contact: errors of impacts over the phases of onset and
// release for t_c/dt from 5 to 400, each scheme and law. CSV on stdout; scripts/accuracy_cost draws it.
#include <cstdio>
#include <string>

#include "physics/contact/contact_duration.h"
#include "physics/impact/impact.h"

namespace {

using namespace mikromakro::physics;

// The small discs of the paper's cell.
constexpr double radius = 3.71e-3, k_n = 352.1, gamma_n = 0.19;
const double mass = 6.36 * M_PI * radius * radius, m12 = mass / 2;
constexpr double speed = 1e-4;  // m/s; so small that the normal does not turn

template <Effects effects>
void print_errors(const char* law, const Impact& impact) {
  constexpr const char* schemes[] = {"half_step", "same_instant", "share_of_step"};
  constexpr const char* quantities[] = {"restitution", "slip", "duration", "energy"};
  const auto exact = exact_rebound<effects>(impact);
  for (const double steps : {5, 7, 10, 14, 20, 28, 40, 57, 80, 113, 160, 226, 320, 400}) {
    for (int scheme = 0; scheme < 3; ++scheme) {
      const auto error = error_over_phases<effects>(impact, steps, static_cast<Scheme>(scheme), exact);
      for (int q = 0; q < impact_quantities; ++q) {
        if (q == slip_after && impact.v_t == 0) continue;
        std::printf("%s,%s,%s,%g,%.9g,%.4e,%.4e\n", law, schemes[scheme], quantities[q], steps, exact[q],
                    error.mean[q], error.rms[q]);
      }
    }
  }
}

}  // namespace

int main() {
  constexpr Effects normal{}, spring{Tangential::spring}, equation_1{Tangential::viscous_coulomb},
      hertz{Tangential::none, false, Normal::hertz};
  const ContactParameters linear{k_n, gamma_n, 0.8 * k_n, 0.15, 0.44};
  ContactParameters elastic = linear, spheres = linear;
  elastic.normal_damping = 0;
  const double t_c = contact_duration(k_n, gamma_n, m12), elastic_t_c = contact_duration(k_n, 0, m12);
  // Hertz's spheres with the elastic duration of the linear law at this speed, and about its restitution.
  const double k_h = std::pow(hertz_contact_duration(1, m12, speed) / elastic_t_c, 2.5);
  spheres.normal_stiffness = k_h / std::sqrt(radius / 2);
  spheres.normal_damping = 0.13;
  ContactParameters elastic_spheres = spheres;
  elastic_spheres.normal_damping = 0;

  std::puts("law,scheme,quantity,steps_per_contact,exact,mean_error,rms_error");
  print_errors<normal>("linear elastic", {elastic, radius, mass, speed, 0, elastic_t_c});
  print_errors<normal>("linear with dashpot", {linear, radius, mass, speed, 0, t_c});
  print_errors<hertz>("Hertz elastic", {elastic_spheres, radius, mass, speed, 0, elastic_t_c});
  print_errors<hertz>("Hertz with dashpot", {spheres, radius, mass, speed, 0, elastic_t_c});
  print_errors<spring>("elastic with spring", {elastic, radius, mass, speed, speed, elastic_t_c});
  print_errors<spring>("dashpot and spring", {linear, radius, mass, speed, speed, t_c});
  print_errors<equation_1>("dashpot and Eq. 1", {linear, radius, mass, speed, speed, t_c});
}
