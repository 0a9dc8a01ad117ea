// SPDX-License-Identifier: GPL-2.0-or-later
// The same scene on one rank and on all ranks of this run (ctest starts it under mpirun): contacts and forces
// agree.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <mpi.h>

#include <cmath>

#include "averaging/averager.h"
#include "averaging/volumes/ring_volumes.h"
#include "engine.h"
#include "packing.h"

namespace mikromakro::test {
namespace {

struct Result {
  std::map<int, Disc> discs;
  std::map<std::pair<int, int>, Contact> contacts;
};

Result sheared_packing(MPI_Comm ranks, const std::string& law, int steps) {
  Engine engine(ranks);
  engine.run(scene("model disc/linear tangential " + law, {}, packing_box, 2, "p p p", "0.002"));
  engine.run(packing(20, 0.05));
  engine.run("fix integrate all nve/disc\ntimestep 4e-5\ncompute contacts all contact/disc\n");
  engine.run(fmt::format("run {}\n", steps));
  return {engine.discs(), engine.contacts()};
}

/// Averages over eight rings about the origin.
Table ring_averages(const Result& result) {
  Frame frame;
  std::map<int, int> index;
  for (const auto& [id, d] : result.discs) {
    index[id] = static_cast<int>(frame.particles.size());
    frame.particles.push_back({id, d.type, {d.x, d.y}, d.radius, {d.v_x, d.v_y}, d.omega, d.mass});
  }
  for (const auto& [ids, c] : result.contacts) {
    frame.contacts.push_back({ids.first,
                              ids.second,
                              index.at(ids.first),
                              index.at(ids.second),
                              {c.n_x, c.n_y},
                              c.overlap,
                              {c.f_x, c.f_y},
                              c.xi});
  }
  std::vector<double> edges;
  for (int k = 0; k <= 8; ++k) edges.push_back(0.01 * k);
  const Averager averager(
      std::make_unique<const RingVolumes>(Eigen::Vector2d::Zero(), edges, 1.0), make_weight("sliced"),
      make_fields({"solid_fraction", "coordination", "velocity", "spin", "fabric", "stress"}), {});
  return averager.solve(averager.frame_sums(frame));
}

class OneRankAgainstAll : public testing::TestWithParam<const char*> {};

TEST_P(OneRankAgainstAll, SameContactsAndForcesAfterAHundredSteps) {
  const auto one = sheared_packing(MPI_COMM_SELF, GetParam(), 100);
  const auto all = sheared_packing(MPI_COMM_WORLD, GetParam(), 100);
  ASSERT_EQ(one.discs.size(), all.discs.size());
  ASSERT_EQ(one.contacts.size(), all.contacts.size());
  double sum = 0, largest = 0, largest_spring = 0;
  for (const auto& [pair, contact] : one.contacts) {
    ASSERT_TRUE(all.contacts.contains(pair)) << pair.first << "-" << pair.second;
    const auto& other = all.contacts.at(pair);
    sum += contact.f_x * contact.f_x + contact.f_y * contact.f_y;
    largest = std::max(largest, std::hypot(contact.f_x - other.f_x, contact.f_y - other.f_y));
    largest_spring = std::max(largest_spring, std::abs(contact.xi - other.xi));
  }
  const double rms = std::sqrt(sum / static_cast<double>(one.contacts.size()));
  std::printf("tangential %s: largest difference of a contact force %.1e of the rms force\n", GetParam(),
              largest / rms);
  // Rounding of the sums of forces in another order, grown by the chaos of 100 steps (two contact durations).
  EXPECT_LT(largest / rms, 1e-12);
  EXPECT_LT(largest_spring, 1e-12 * packing_box);

  const auto rings_one = ring_averages(one), rings_all = ring_averages(all);
  ASSERT_GT(rings_one.columns.size(), 10U);
  for (Eigen::Index column = 0; column < rings_one.rows.cols(); ++column) {
    const double size = rings_one.rows.col(column).cwiseAbs().maxCoeff();
    // The same rounding, in sums of some hundred terms whose signs may cancel.
    EXPECT_LE((rings_one.rows.col(column) - rings_all.rows.col(column)).cwiseAbs().maxCoeff(), 1e-11 * size)
        << rings_one.columns[column].name;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, OneRankAgainstAll,
                         testing::Values("off", "disc/viscous", "disc/cundall_strack"));

}  // namespace
}  // namespace mikromakro::test
