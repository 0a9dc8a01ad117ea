#include "pair_gran_disc.h"

#include <cstdio>
#include <cstring>

#include "comm.h"
#include "compute_pair_gran_local.h"
#include "domain.h"
#include "error.h"
#include "fix_nve_disc.h"
#include "force.h"
#include "modify.h"
#include "output.h"
#include "update.h"

namespace mikromakro::liggghts {

using namespace LAMMPS_NS;
using physics::Tangential;

namespace {

Tangential tangential_of(int64_t hash) {
  switch (static_cast<int>((hash >> 6) & 63)) {
    case tangential_model_viscous:
      return Tangential::viscous_coulomb;
    case tangential_model_cundall_strack:
      return Tangential::spring;
    default:
      return Tangential::none;
  }
}

/// Whether every fix that integrates is fix nve/disc with `velocity predicted`.
bool integrators_predict_velocities(const Modify& modify) {
  bool any = false;
  for (int k = 0; k < modify.nfix; ++k) {
    if (std::strncmp(modify.fix[k]->style, "nve", 3) != 0) continue;
    const auto* integrator = dynamic_cast<const FixNveDisc*>(modify.fix[k]);
    if (!integrator || !integrator->predicts_velocities()) return false;
    any = true;
  }
  return any;
}

const char* tangential_name(Tangential tangential) {
  switch (tangential) {
    case Tangential::none:
      return "off";
    case Tangential::viscous_coulomb:
      return "disc/viscous";
    default:
      return "disc/cundall_strack";
  }
}

}  // namespace

PairGranDisc::PairGranDisc(LAMMPS* engine, PairGran* parent, int64_t hash) : Pointers(engine), hash_(hash) {
  effects_.tangential = tangential_of(hash);
  // Spring and slip rate keep their signs when the particles change places, so "0": no sign change between
  // the two copies.
  if (effects_.spring()) {
    parent->add_history_value("xi", "0");
    parent->add_history_value("slip_rate", "0");
  }
}

void PairGranDisc::require_two_dimensions() const {
  if (domain->dimension != 2) {
    error->all(
        FLERR,
        "pair_style gran model disc/linear: discs live in two dimensions; put 'dimension 2' before the box");
  }
  if (force->newton_pair) {
    error->all(FLERR, "pair_style gran model disc/linear: needs 'newton off' before the box is created");
  }
}

void PairGranDisc::settings(int narg, char** arg, LIGGGHTS::IContactHistorySetup* /*history*/) {
  require_two_dimensions();
  bool tangential_damping = false;
  for (int k = 0; k < narg; k += 2) {
    const std::string key = arg[k];
    const std::string value = k + 1 < narg ? arg[k + 1] : "nothing";
    if (value != "on" && value != "off") {
      error->all(
          FLERR,
          ("pair_style gran model disc/linear: '" + key + "': expected on or off, got " + value).c_str());
    }
    const bool on = value == "on";
    if (key == "tangential_damping") {
      tangential_damping = on;
    } else if (key == "limitForce") {
      effects_.no_attraction = on;
    } else if (key == "absolute_damping") {
      // Accepted for scripts of the stock law; the disc law knows only absolute damping constants.
      if (!on)
        error->all(
            FLERR,
            "pair_style gran model disc/linear: has only 'absolute_damping on' (gamman_abs, gammat_abs)");
    } else {
      error->all(FLERR, ("pair_style gran model disc/linear: unknown keyword '" + key +
                         "'; expected tangential_damping, limitForce or absolute_damping")
                            .c_str());
    }
  }
  if (effects_.spring())
    effects_.tangential = tangential_damping ? Tangential::damped_spring : Tangential::spring;
  choose_loops();
}

void PairGranDisc::init_granular() {
  require_two_dimensions();
  if (force->cg_active())
    error->all(FLERR, "pair_style gran model disc/linear: works without coarse graining only");
  read_material_constants();
  check_time_step();
  predicted_ = integrators_predict_velocities(*modify);
  schedule_.look_up(*lmp);
  recorded_step_ = -1;
}

void PairGranDisc::write_restart_settings(FILE* file) {
  const int flags[2] = {static_cast<int>(effects_.tangential), effects_.no_attraction};
  std::fwrite(&hash_, sizeof hash_, 1, file);
  std::fwrite(flags, sizeof flags, 1, file);
}

void PairGranDisc::read_restart_settings(FILE* file, int64_t /*hash*/) {
  int settings[3] = {0, 0, 0};  // the flags; whether they were there
  if (comm->me == 0) {
    int64_t written = -1;
    settings[2] = std::fread(&written, sizeof written, 1, file) == 1 && written == hash_ &&
                  std::fread(settings, sizeof(int), 2, file) == 2;
  }
  MPI_Bcast(settings, 3, MPI_INT, 0, world);
  if (!settings[2]) {
    error->all(
        FLERR,
        "pair_style gran model disc/linear: the restart file ends inside the settings of the pair style");
  }
  effects_ = {static_cast<Tangential>(settings[0]), settings[1] != 0};
  choose_loops();
}

int PairGranDisc::get_history_offset(const std::string name) {
  if (!effects_.spring()) return -1;
  return name == "xi" ? 0 : name == "slip_rate" ? 1 : -1;
}

bool PairGranDisc::contact_match(const std::string kind, const std::string model) {
  if (kind == "normal") return model == "disc/linear";
  if (kind == "tangential") return model == tangential_name(effects_.tangential);
  if (kind == "surface") return model == "default";
  return model == "off";
}

const std::vector<AppliedContact>* PairGranDisc::applied_contacts() const {
  return recorded_step_ == update->ntimestep ? &applied_ : nullptr;
}

void PairGranDisc::compute_force(PairGran* pair, int eflag, int vflag, int addflag) {
  if (eflag || vflag) {
    pair->ev_setup(eflag, vflag);
  } else {
    pair->evflag = pair->vflag_fdotr = 0;
  }
  recording_ = pair->computeflag() && schedule_.due(*update, *output);
  if (recording_) applied_.clear();
  if (atom->nlocal > 0) {
    const bool observed = recording_ || pair->evflag || addflag;
    (this->*(observed ? observed_loop_ : plain_loop_))(*pair, addflag != 0);
  }
  if (recording_) recorded_step_ = update->ntimestep;
  if (addflag && pair->cpl()) pair->cpl_pair_finalize();
}

}  // namespace mikromakro::liggghts
