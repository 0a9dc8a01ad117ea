// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "measured_error.h"
#include "walled_discs.h"

namespace mikromakro {
namespace {

// Latzel2001 Eqs. 17-20: eps l = Delta = -overlap n in the mean of squares, l = 2 n. Two contacts fix eps:
//   n = (1, 0), overlap 0.2:     eps (2, 0) = (-0.2, 0)
//   n = (0.6, 0.8), overlap 0.1: eps (1.2, 1.6) = (-0.06, -0.08)
// It is not symmetric, since F and B do not commute.
TEST(ElasticStrain, TakesBranchesToContactDisplacements) {
  const Frame frame = disc_between_walls({{{1, 0}, {0, 0}, 0.2}, {{0.6, 0.8}, {0, 0}, 0.1}});
  const RingAverage average(frame, whole_ring({"elastic_strain"}));
  expect_measured(average.at("eps_rr"), -0.1, few_roundings);
  expect_measured(average.at("eps_rphi"), 0.0375, few_roundings);
  expect_measured(average.at("eps_phir"), 0, few_roundings);
  expect_measured(average.at("eps_phiphi"), -0.05, few_roundings);
}

// Along x disc 1 (radius 2) has overlaps 0.2 and 0.1, disc 2 (radius 1, opposite) 0.1: the fit weights with
// l^2, not with the volume: (0.2 2 + 0.1 2 + 0.1 1)/(4 + 4 + 1); along y 0.1/2.
TEST(ElasticStrain, IsTheLeastSquaresFitOverAllDiscs) {
  Frame frame = disc_between_walls({{{1, 0}, {0, 0}, 0.2}, {{-1, 0}, {0, 0}, 0.1}, {{0, 1}, {0, 0}, 0.1}});
  add_disc(frame, {-10, 0}, 1, {{{1, 0}, {0, 0}, 0.1}});
  const RingAverage average(frame, whole_ring({"elastic_strain"}));
  expect_measured(average.at("eps_rr"), -0.7 / 9, few_roundings);
  expect_measured(average.at("eps_phiphi"), -0.05, few_roundings);
}

// With l = (a - overlap) n at walls the fit has the l of the branch: -0.2/1.8 and -0.1/1.9.
TEST(ElasticStrain, UsesTheBranchThatWasAskedFor) {
  RingSetup setup = whole_ring({"elastic_strain"});
  setup.options.branch = Branch::contact;
  const RingAverage average(disc_between_walls({{{1, 0}, {0, 0}, 0.2}, {{0, 1}, {0, 0}, 0.1}}), setup);
  expect_measured(average.at("eps_rr"), -0.2 / 1.8, few_roundings);
  expect_measured(average.at("eps_phiphi"), -0.1 / 1.9, few_roundings);
}

}  // namespace
}  // namespace mikromakro
