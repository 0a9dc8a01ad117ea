// SPDX-License-Identifier: GPL-2.0-or-later
#include "output/frame_gathering.h"

#include <mpi.h>

#include <algorithm>
#include <array>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "engine/arguments.h"
#include "engine/engine_access.h"
#include "engine/engine_lists.h"
#include "engine/first_rank.h"
#include "fix.h"
#include "group.h"
#include "law/agreement.h"
#include "law/contact_rows.h"
#include "law/disc_law.h"
#include "modify.h"
#include "options/volume_options.h"
#include "update.h"

namespace mikromakro::styles {

using LAMMPS_NS::LAMMPS;

namespace {

// id type x y radius vx vy omegaz mass, as in ParticleColumn.
using DiscRow = std::array<double, static_cast<std::size_t>(ParticleColumn::count)>;
static_assert(contact_columns == contact_disc_columns);

template <class T>
constexpr ColumnSet first_columns(T count) {
  return (ColumnSet{1} << static_cast<unsigned>(count)) - 1;
}

/// Gathers the rows of all ranks on the first one, in rank order.
template <class Row>
std::vector<Row> gather(const std::vector<Row>& mine, LAMMPS& engine) {
  const bool first = engine.comm->me == 0;
  const int count = static_cast<int>(mine.size());
  std::vector<int> counts(first ? engine.comm->nprocs : 0);
  MPI_Gather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, 0, engine.world);
  std::vector<int> offsets(counts.size());
  std::size_t total = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    offsets[k] = static_cast<int>(total);
    total += static_cast<std::size_t>(counts[k]);
  }
  std::vector<Row> all(total);
  // Counts whole rows, so that large packings do not overflow an int.
  MPI_Datatype row = MPI_DATATYPE_NULL;
  MPI_Type_contiguous(static_cast<int>(sizeof(Row) / sizeof(double)), MPI_DOUBLE, &row);
  MPI_Type_commit(&row);
  MPI_Gatherv(mine.data(), count, row, all.data(), counts.data(), offsets.data(), row, 0, engine.world);
  MPI_Type_free(&row);
  return all;
}

std::vector<DiscRow> own_discs(const LAMMPS_NS::Atom& atom, int group_bit) {
  std::vector<DiscRow> rows;
  rows.reserve(static_cast<std::size_t>(atom.nlocal));
  for (int i = 0; i < atom.nlocal; ++i) {
    if (!(atom.mask[i] & group_bit)) continue;
    rows.push_back({static_cast<double>(atom.tag[i]), static_cast<double>(atom.type[i]), atom.x[i][0],
                    atom.x[i][1], atom.radius[i], atom.v[i][0], atom.v[i][1], atom.omega[i][2],
                    atom.rmass[i]});
  }
  return rows;
}

void take_discs(std::vector<DiscRow> rows, RawFrame& frame) {
  std::sort(rows.begin(), rows.end(), [](const DiscRow& a, const DiscRow& b) { return a[0] < b[0]; });
  frame.particles.reserve(rows.size());
  for (const DiscRow& d : rows) {
    frame.particles.push_back({static_cast<std::int64_t>(d[0]),
                               static_cast<int>(d[1]),
                               {d[2], d[3]},
                               d[4],
                               {d[5], d[6]},
                               d[7],
                               d[8]});
  }
}

void take_contacts(const std::vector<ContactRow>& rows, RawFrame& frame) {
  frame.contacts.rows.resize(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    auto& value = frame.contacts.rows[i].value;
    value.fill(not_given);
    std::copy(rows[i].begin(), rows[i].end(), value.begin());
  }
}

// The state of a wall is the global vector of its fix, whose evaluation is collective.
std::vector<WallState> wall_states(const LAMMPS_NS::Modify& modify) {
  std::vector<WallState> walls;
  for (LAMMPS_NS::Fix* fix : fixes(modify)) {
    const std::string style = fix->style;
    if (!fix->vector_flag || (style != "couette/2d" && style != "biaxial/2d" && style != "wall/disc"))
      continue;
    const auto* with_height = dynamic_cast<const KnowsHeight*>(fix);
    walls.push_back({fix->id, style, {}, with_height == nullptr || with_height->given_height() > 0});
    for (int i = 0; i < fix->size_vector; ++i) walls.back().numbers.push_back(fix->compute_vector(i));
  }
  return walls;
}

Box box_of(const LAMMPS_NS::Domain& domain) {
  return {{domain.boxlo[0], domain.boxlo[1]},
          {domain.boxhi[0], domain.boxhi[1]},
          {domain.xperiodic != 0, domain.yperiodic != 0}};
}

}  // namespace

RawFrame gather_frame(LAMMPS& engine, int group_bit, const std::string& style) {
  RawFrame frame;
  frame.step = engine.update->ntimestep;
  frame.time = time_now(engine);
  frame.box = box_of(*engine.domain);
  frame.particle_file = "step " + std::to_string(frame.step);
  frame.first_particle_line = 1;
  frame.particles_given = first_columns(ParticleColumn::count);
  frame.with_contacts = true;
  frame.contacts.given = first_columns(contact_disc_columns);
  frame.contacts.file = "contacts of " + frame.particle_file;
  frame.contacts.first_line = 1;
  frame.walls = wall_states(*engine.modify);

  std::vector<ContactRow> contacts;
  int missing = append_contact_rows(engine, group_bit, contacts) ? 0 : 1;
  MPI_Allreduce(MPI_IN_PLACE, &missing, 1, MPI_INT, MPI_MAX, engine.world);
  if (missing != 0)
    stop(engine, style, "the forces of step " + std::to_string(frame.step) + " were not recorded");
  take_discs(gather(own_discs(*engine.atom, group_bit), engine), frame);
  take_contacts(gather(contacts, engine), frame);
  return frame;
}

void require_orthogonal_box(LAMMPS& engine, const std::string& style) {
  if (engine.domain->triclinic != 0)
    stop(engine, style, "expected an orthogonal box, got a tilted (triclinic) one");
}

void warn_of_height(LAMMPS& engine, const LAMMPS_NS::Fix& fix, double height) {
  const DiscLaw& law = *active_disc_law(engine);
  double largest = 0;
  for (int type = 1; type <= engine.atom->ntypes; ++type)
    largest = std::max(largest, law.largest_radius(type));
  if (height == 0 || largest == 0 || is_plausible_height(height, largest)) return;
  warn(engine, std::string("fix ") + fix.id + " (" + fix.style + "): height " + text_of(height) + " m is " +
                   text_of(height / largest) + " times the radius of the largest discs (it is in m)");
}

void warn_of_discs_outside(LAMMPS& engine, const LAMMPS_NS::Fix& fix) {
  const LAMMPS_NS::Atom& atom = *engine.atom;
  LAMMPS_NS::bigint outside =
      std::count_if(atom.mask, atom.mask + atom.nlocal, [&](int mask) { return (mask & fix.groupbit) == 0; });
  MPI_Allreduce(MPI_IN_PLACE, &outside, 1, MPI_LMP_BIGINT, MPI_SUM, engine.world);
  if (outside == 0) return;
  warn(engine, std::string("fix ") + fix.id + " (" + fix.style + "): " + std::to_string(outside) +
                   " discs are not in group " + engine.group->names[fix.igroup] +
                   ": contacts with them are left out, and are missing from stress and coordination");
}

}  // namespace mikromakro::styles
