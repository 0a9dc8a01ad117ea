// SPDX-License-Identifier: GPL-2.0-or-later
// Coordination number of each frame of two dumps, and how long an elastic contact of 5 g discs with k_n = 200
// N/m lasts: example PARTICLES CONTACTS
#include <cstdio>

#include "io/frames/frame_stream.h"
#include "model/error.h"
#include "physics/contact/contact_duration.h"

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    mikromakro::FrameSource source;
    source.particle_files = {argv[1]};
    source.contact_files = {argv[2]};
    mikromakro::FrameStream stream(source);
    for (mikromakro::Frame frame; stream.next(frame);) {
      std::size_t ends = 0;
      for (const mikromakro::Contact& contact : frame.contacts) ends += contact.with_wall() ? 1 : 2;
      std::printf("step %lld: %.4f contacts per disc\n", static_cast<long long>(frame.step),
                  static_cast<double>(ends) / static_cast<double>(frame.particles.size()));
    }
  } catch (const mikromakro::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::printf("t_c = %.4g ms\n", 1e3 * mikromakro::physics::contact_duration(200, 0, 0.0025));
}
