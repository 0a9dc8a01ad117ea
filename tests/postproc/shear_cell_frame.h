// SPDX-License-Identifier: GPL-2.0-or-later
// A snapshot of the shear cell: a real, disordered packing.
#pragma once

#include "io/frames/frame_stream.h"
#include "ring_average.h"

namespace mikromakro {

inline constexpr double shear_cell_k_n = 352.1;  // N/m
inline constexpr int shear_cell_ring_count = 60;

inline Frame read_shear_cell() {
  FrameSource source;
  source.particle_files = {TEST_DATA "/reference/couette_small_particles.dump.gz"};
  source.contact_files = {TEST_DATA "/reference/couette_small_contacts.dump.gz"};
  FrameStream stream(source);
  Frame frame;
  EXPECT_TRUE(stream.next(frame));
  return frame;
}

inline Frame with_elastic_normal_forces(Frame frame) {
  for (Contact& contact : frame.contacts) contact.force = -shear_cell_k_n * contact.overlap * contact.normal;
  return frame;
}

/// All fields in rings from the wheel to the outer ring.
inline RingSetup shear_cell_rings() {
  RingSetup setup;
  setup.edges = equal_ring_edges(0.1032, 0.1782, shear_cell_ring_count);
  setup.height = 0.006;
  setup.options.bulk_types = {1, 2};
  setup.fields = {"all"};
  setup.field_options = {shear_cell_k_n, 0.44, 0};
  return setup;
}

}  // namespace mikromakro
