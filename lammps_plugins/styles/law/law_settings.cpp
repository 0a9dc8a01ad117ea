// SPDX-License-Identifier: GPL-2.0-or-later
#include "law/law_settings.h"

#include <mpi.h>

#include <array>

#include "comm.h"
#include "engine/arguments.h"
#include "engine/restart_state.h"
#include "lammps.h"

namespace mikromakro::styles {

using physics::Normal;
using physics::Tangential;

namespace {

/// The settings as stored in a restart file.
struct SavedSettings {
  std::int64_t key;
  StateHeader header;
  double impact_velocity;
  std::array<std::int32_t, 4> effects;
};

}  // namespace

void LawSettings::reset(Normal normal, Tangential tangential) {
  effects_ = {};
  effects_.normal = normal;
  effects_.tangential = tangential;
  tangential_damping_ = false;
  impact_velocity_ = 0;
}

bool LawSettings::take(Arguments& arguments) {
  if (arguments.take_switch("damping", effects_.normal_dashpot) ||
      arguments.take_switch("tangential_damping", tangential_damping_) ||
      arguments.take_switch("limitForce", effects_.no_attraction)) {
    return true;
  }
  if (!physics::depends_on_velocity(effects_.normal) || !arguments.take_once("impact_velocity")) return false;
  impact_velocity_ = arguments.positive("impact_velocity");
  return true;
}

void LawSettings::finish(const Arguments& arguments) {
  if (tangential_damping_ && !effects_.spring())
    arguments.fail(
        "'tangential_damping on': expected 'tangential disc/cundall_strack': the dashpot is parallel to its "
        "spring");
  if (effects_.spring())
    effects_.tangential = tangential_damping_ ? Tangential::damped_spring : Tangential::spring;
}

void LawSettings::write(std::FILE* file, std::int64_t key) const {
  const SavedSettings settings{key,
                               {.size = sizeof(SavedSettings)},
                               impact_velocity_,
                               {static_cast<int>(effects_.tangential), effects_.no_attraction,
                                static_cast<int>(effects_.normal), effects_.normal_dashpot}};
  std::fwrite(&settings, sizeof settings, 1, file);
}

void LawSettings::read(LAMMPS_NS::LAMMPS& engine, const std::string& style, std::FILE* file,
                       std::int64_t key) {
  SavedSettings settings{};
  int complete = 0;
  if (engine.comm->me == 0)
    complete = std::fread(&settings, sizeof settings, 1, file) == 1 && settings.key == key;
  MPI_Bcast(&settings, sizeof settings, MPI_BYTE, 0, engine.world);
  MPI_Bcast(&complete, 1, MPI_INT, 0, engine.world);
  if (!complete) stop(engine, style, "the restart file ends inside the settings of the pair style");
  if (settings.header != StateHeader{.size = sizeof settings})
    stop(engine, style,
         "the restart file was written by another version of the styles; expected version " +
             std::to_string(version_of_states) + ", got " + std::to_string(settings.header.version));
  const auto& [tangential, no_attraction, normal, normal_dashpot] = settings.effects;
  effects_ = {static_cast<Tangential>(tangential), no_attraction != 0, static_cast<Normal>(normal),
              normal_dashpot != 0};
  tangential_damping_ = effects_.tangential == Tangential::damped_spring;
  impact_velocity_ = settings.impact_velocity;
}

}  // namespace mikromakro::styles
