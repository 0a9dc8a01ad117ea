#include "pair_gran_disc.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <string>

#include "arguments.h"
#include "comm.h"
#include "compute_pair_gran_local.h"
#include "domain.h"
#include "effects_line.h"
#include "fix_nve_disc.h"
#include "force.h"
#include "modify.h"
#include "neighbor.h"
#include "output.h"
#include "style_maps.h"
#include "time_step_check.h"
#include "update.h"

namespace mikromakro::liggghts {

using namespace LAMMPS_NS;
using physics::Normal;
using physics::Tangential;

namespace {

Normal normal_of(int64_t hash) {
  return static_cast<int>(hash & 63) == normal_model_hertz ? Normal::hertz : Normal::linear;
}

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

const char* normal_name(Normal normal) {
  return normal == Normal::hertz ? "disc/hertz" : "disc/linear";
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
  effects_.normal = normal_of(hash);
  effects_.tangential = tangential_of(hash);
  // Spring and slip rate keep their signs when the particles change places, so "0": no sign change between
  // the two copies.
  if (effects_.spring()) {
    parent->add_history_value("xi", "0");
    parent->add_history_value("slip_rate", "0");
  }
}

std::string PairGranDisc::style() const {
  return std::string("pair_style gran model ") + normal_name(effects_.normal);
}

void PairGranDisc::fail(const std::string& what) const {
  stop(*lmp, style(), what);
}

void PairGranDisc::require_two_dimensions() const {
  if (domain->dimension != 2) fail("discs live in two dimensions; put 'dimension 2' before the box");
  if (force->newton_pair) fail("needs 'newton off' before the box is created");
}

bool PairGranDisc::take_switch(Arguments& arguments, const char* key, bool& value) const {
  if (!arguments.take(key)) return false;
  const std::string word = arguments.more() ? arguments.word(key) : "nothing";
  if (word != "on" && word != "off") fail("'" + std::string(key) + "': expected on or off, got " + word);
  value = word == "on";
  return true;
}

void PairGranDisc::settings(int narg, char** arg, LIGGGHTS::IContactHistorySetup* /*history*/) {
  require_two_dimensions();
  bool tangential_damping = false, absolute_damping = true;
  const bool hertz = effects_.normal == Normal::hertz;
  Arguments arguments(*lmp, style(), narg, arg);
  while (arguments.more()) {
    if (take_switch(arguments, "damping", effects_.normal_dashpot) ||
        take_switch(arguments, "tangential_damping", tangential_damping) ||
        take_switch(arguments, "limitForce", effects_.no_attraction) ||
        take_switch(arguments, "absolute_damping", absolute_damping)) {
      continue;
    }
    if (hertz && arguments.take("impact_velocity")) {
      impact_velocity_ = arguments.positive("impact_velocity");
    } else {
      fail("unknown keyword '" + arguments.word("keyword") +
           "'; expected damping, tangential_damping, limitForce" +
           (hertz ? ", absolute_damping or impact_velocity" : " or absolute_damping"));
    }
  }
  // Accepted for scripts of the stock law; the disc law knows only absolute damping constants.
  if (!absolute_damping) fail("has only 'absolute_damping on' (gamman_abs, gammat_abs)");
  if (effects_.spring())
    effects_.tangential = tangential_damping ? Tangential::damped_spring : Tangential::spring;
  choose_loops();
}

void PairGranDisc::init_granular() {
  require_two_dimensions();
  if (force->cg_active()) fail("works without coarse graining only");
  read_material_constants();
  run_started_ = false;
  predicted_ = integrators_predict_velocities(*modify);
  schedule_.look_up(*lmp);
  readers_.look_up(*lmp);
  packed_.may_stay_open = packed_.open = false;
  packed_.step = -1;
  recorded_step_ = -1;
}

/// Once in each run, at its set-up; the engine also initialises when it writes a restart file.
void PairGranDisc::start_run(const NeighList& list) {
  run_started_ = true;
  check_time_step(*lmp, list, style(), {effects_, parameters_, impact_velocity_});
  announce_effects();
}

void PairGranDisc::announce_effects() const {
  if (comm->me != 0) return;
  const std::string line = effects_line(effects_, *modify, predicted_) + "\n";
  for (FILE* file : {screen, logfile}) {
    if (file) std::fputs(line.c_str(), file);
  }
}

namespace {

/// What a restart file holds of the settings.
struct SavedSettings {
  int64_t hash;
  double impact_velocity;
  std::array<int32_t, 4> effects;
};

}  // namespace

void PairGranDisc::write_restart_settings(FILE* file) {
  const SavedSettings settings{hash_,
                               impact_velocity_,
                               {static_cast<int>(effects_.tangential), effects_.no_attraction,
                                static_cast<int>(effects_.normal), effects_.normal_dashpot}};
  std::fwrite(&settings, sizeof settings, 1, file);
}

void PairGranDisc::read_restart_settings(FILE* file, int64_t /*hash*/) {
  SavedSettings settings{};
  int complete = 0;
  if (comm->me == 0) {
    complete = std::fread(&settings, sizeof settings, 1, file) == 1 && settings.hash == hash_;
  }
  MPI_Bcast(&settings, sizeof settings, MPI_BYTE, 0, world);
  MPI_Bcast(&complete, 1, MPI_INT, 0, world);
  if (!complete) fail("the restart file ends inside the settings of the pair style");
  const auto& [tangential, no_attraction, normal, normal_dashpot] = settings.effects;
  effects_ = {static_cast<Tangential>(tangential), no_attraction != 0, static_cast<Normal>(normal),
              normal_dashpot != 0};
  impact_velocity_ = settings.impact_velocity;
  choose_loops();
}

int PairGranDisc::get_history_offset(const std::string name) {
  if (!effects_.spring()) return -1;
  return name == "xi" ? 0 : name == "slip_rate" ? 1 : -1;
}

bool PairGranDisc::contact_match(const std::string kind, const std::string model) {
  if (kind == "normal") return model == normal_name(effects_.normal);
  if (kind == "tangential") return model == tangential_name(effects_.tangential);
  if (kind == "surface") return model == "default";
  return model == "off";
}

const physics::ContactParameters& PairGranDisc::parameters(int type_1, int type_2) const {
  return parameters_[static_cast<std::size_t>(type_1 - 1) * atom->ntypes + type_2 - 1];
}

const std::vector<AppliedContact>* PairGranDisc::applied_contacts() const {
  return recorded_step_ == update->ntimestep ? &applied_ : nullptr;
}

std::size_t PairGranDisc::bytes_of_pairs() const {
  return pairs_.size() * sizeof(physics::DiscPair) + histories_.size() * sizeof(double*) +
         in_contact_.size() + near_.bytes() + applied_.capacity() * sizeof(AppliedContact);
}

std::size_t PairGranDisc::bytes_in_engine() const {
  return histories_.size() * (2 * sizeof(double) + sizeof(int));
}

std::size_t PairGranDisc::contacts() const {
  return std::count_if(pairs_.begin(), pairs_.end(), [this](const physics::DiscPair& pair) {
    return physics::are_near(packed_.discs[pair.i], packed_.discs[pair.j], 0);
  });
}

void PairGranDisc::compute_force(PairGran* pair, int eflag, int vflag, int addflag) {
  if (eflag || vflag) {
    pair->ev_setup(eflag, vflag);
  } else {
    pair->evflag = pair->vflag_fdotr = 0;
  }
  if (!run_started_) start_run(*pair->list);
  if (packed_.check_is_off) neighbor->build_once = 0;
  if (packed_.clear_is_off) forces_are_not_cleared(*update->integrate) = 0;
  forces_are_stale_ = packed_.clear_is_off;
  packed_.check_is_off = packed_.clear_is_off = false;
  // The same on all ranks, with discs or without.
  packed_.open = pair->computeflag() && will_stay_open();
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
