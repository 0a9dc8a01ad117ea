// SPDX-License-Identifier: GPL-2.0-or-later
// A fix that the styles do not know takes part in open steps by the interface alone (law/fix_on_rows.h).
#include <gtest/gtest.h>

#include "atom.h"
#include "dialect.h"
#include "engine.h"
#include "engine/engine_access.h"
#include "fix.h"
#include "law/disc_law.h"
#include "law/fix_on_rows.h"
#include "law/fixes_in_step.h"

namespace mikromakro::test {
namespace {

/// Draws discs to the origin with the force -k r, k = 2 N/m, and turns them with 1e-5 N m.
template <class... Interfaces>
class DrawsToTheOrigin : public styles::FixOfEngine, public Interfaces... {
 public:
  DrawsToTheOrigin(LAMMPS_NS::LAMMPS* engine, int narg, char** arg) : FixOfEngine(engine, narg, arg) {}
  int setmask() override { return LAMMPS_NS::FixConst::POST_FORCE; }
  void setup(int vflag) override { post_force(vflag); }
  void post_force(int /*vflag*/) override {
    styles::DiscLaw* law = styles::active_disc_law(*lmp);
    styles::AddedLoads loads(law, *atom);
    for (int i = 0; i < atom->nlocal; ++i) {
      const auto* row = law->evaluated_row(i);
      loads.add(i, {-2 * row->x(), -2 * row->y()}, 1e-5);
    }
  }
};

class OnRows : public styles::FixOnRows {
 public:
  int calls_on_rows() const override { return LAMMPS_NS::FixConst::POST_FORCE; }
};

struct Outcome {
  std::map<int, Disc> discs;
  bool open;
};

/// Discs that collapse onto one another.
Outcome run(const std::string& fix, const std::string& lines) {
  Engine engine;
  auto& fixes = styles::fix_styles(*engine.lammps().modify);
  fixes["draw/rows"] = styles::make_fix<DrawsToTheOrigin<OnRows>>;
  fixes["draw/arrays"] = styles::make_fix<DrawsToTheOrigin<>>;
  engine.run(
      scene("model disc/linear tangential disc/cundall_strack", {}, 0.12, 2, "f f p", "0.0006") +
      "timestep 4e-5\ncreate_discs box -0.08 0.08 -0.08 0.08 seed 7 density 6.36 velocity 0.1 discs 150 1 "
      "0.004\nfix integrate all nve/disc\nfix draw all " +
      fix + "\n" + lines + "run 1000\n");
  return {engine.discs(), styles::active_disc_law(engine.lammps())->steps_may_be_open()};
}

void expect_same_bits(const Outcome& a, const Outcome& b) {
  ASSERT_EQ(a.discs.size(), b.discs.size());
  for (const auto& [id, disc] : a.discs) {
    EXPECT_EQ(disc.x, b.discs.at(id).x) << id;
    EXPECT_EQ(disc.v_y, b.discs.at(id).v_y) << id;
    EXPECT_EQ(disc.omega, b.discs.at(id).omega) << id;
  }
}

// No tolerance: the same arithmetic on the same numbers.
TEST(ForeignFix, TakesPartInOpenStepsByTheInterfaceAlone) {
  const Outcome open = run("draw/rows", ""), unknown = run("draw/arrays", ""),
                seen = run("draw/rows", "compute energy all ke\nfix look all ave/time 1 1 1 c_energy\n");
  EXPECT_TRUE(open.open);
  EXPECT_FALSE(unknown.open);
  expect_same_bits(open, unknown);
  expect_same_bits(open, seen);
}

}  // namespace
}  // namespace mikromakro::test
