// SPDX-License-Identifier: GPL-2.0-or-later
// The scene in the words of the engines' input scripts.
#pragma once

#include <string>

#include "disc_scene.h"
#include "engine.h"

namespace mikromakro::bench {

/// Lines before the box.
std::string settings(const std::string& boundary);

/// Material constants of LIGGGHTS.
std::string constants(const physics::ContactParameters& material);

/// Groups (free, inner, outer, wall), neighbour list, material, pair style and time step.
void set_up_law(test::Engine& engine, const DiscScene& scene, const std::string& pair_style);

/// Reads the scene from its data file and sets the law up.
void read_scene(test::Engine& engine, const DiscScene& scene, const std::string& file,
                const std::string& pair_style);

/// What moves discs and walls: our fixes, or those of stock LIGGGHTS.
std::string disc_integration(const DiscScene& scene);
std::string stock_integration(const DiscScene& scene);

/// Law, integration and rings of LAMMPS: its own, and ours in it.
std::string lammps_stock_styles(const DiscScene& scene);
std::string lammps_disc_styles(const DiscScene& scene);

/// A script for the programs `lmp` and `lmp-disc` that runs `warm_up` and then `steps` steps of the scene.
std::string lammps_script(const DiscScene& scene, const std::string& data_file, const std::string& styles,
                          int warm_up, int steps);

/// A name in the folder for temporary files, of this process alone.
std::string temporary_file(const std::string& name);

}  // namespace mikromakro::bench
