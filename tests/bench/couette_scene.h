// Run A of the paper, 2511 + 400 discs between two rough rings, as a scene for benchmarks: prepared once,
// then read from a restart file under any contact law and integrator.
#pragma once

#include <string>

#include "engine.h"

namespace mikromakro::bench {

/// Prepares the packing (compaction in 0.5 s, a little shear) with the disc law and writes it to a restart
/// file.
void prepare_couette_cell(const std::string& restart_file);

/// How the scene is to be simulated.
struct Simulation {
  std::string pair_style;   // the arguments of pair_style gran
  std::string integration;  // lines that move discs and walls; groups: free, inner, outer, wall
};

/// Reads the packing and lets the wheel turn.
void start_couette_cell(test::Engine& engine, const std::string& restart_file, const Simulation& simulation);

}  // namespace mikromakro::bench
