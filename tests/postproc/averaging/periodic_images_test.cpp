// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/periodic_images.h"

#include <gtest/gtest.h>

#include "model/error.h"

namespace mikromakro {
namespace {

using Places = std::vector<Eigen::Vector2d>;

Places images(const Box& box, const Box& part, const Eigen::Vector2d& place, double reach) {
  Places found = {{99, 99}};
  PeriodicImages(box, part).of(place, reach, found);
  return found;
}

const Box both{{0, 0}, {4, 3}, {true, true}};
const Box cell{{0, 0}, {4, 3}, {}};

TEST(PeriodicImages, WithoutPeriodicBoundariesThePlaceItselfWhereverItIs) {
  EXPECT_EQ(images({{0, 0}, {4, 3}, {}}, cell, {-7, 99}, 0), (Places{{-7, 99}}));
  // A box without a length has no images.
  EXPECT_EQ(images({{0, 0}, {0, 0}, {true, true}}, cell, {-7, 99}, 1), (Places{{-7, 99}}));
}

TEST(PeriodicImages, AreAllWithinTheReach) {
  EXPECT_EQ(images(both, cell, {1, 1}, 0.5), (Places{{1, 1}}));
  EXPECT_EQ(images(both, cell, {0.25, 1}, 0.5), (Places{{0.25, 1}, {4.25, 1}}));
  EXPECT_EQ(images(both, cell, {3.75, 2.75}, 0.5),
            (Places{{-0.25, -0.25}, {3.75, -0.25}, {-0.25, 2.75}, {3.75, 2.75}}));
  // A reach of more than the box.
  EXPECT_EQ(images(both, cell, {1, 1}, 5.5).size(), 4U * 5U);
  // A part far away, and a place that was never brought back into the box.
  EXPECT_EQ(images(both, {{40, 30}, {44, 33}, {}}, {-399, 1}, 0.5), (Places{{41, 31}}));
}

TEST(PeriodicImages, OneAxisOnly) {
  const Box along_x{{0, 0}, {4, 3}, {true, false}};
  EXPECT_EQ(images(along_x, cell, {0.25, -0.25}, 0.5), (Places{{0.25, -0.25}, {4.25, -0.25}}));
  EXPECT_EQ(images(along_x, cell, {4.5, 3.5}, 0), (Places{{0.5, 3.5}}));
}

// A centre on either edge, a rounding beside it, or a little outside counts exactly once in the whole box,
// also where low + period is rounded to below high, and exactly twice in two boxes.
TEST(PeriodicImages, OfAPointAreAsManyAsThePartHasPeriods) {
  for (const double low : {0.0, 0.1, -0.3, -4.0}) {
    for (const double high : {0.3, 0.7, 1.0}) {
      const Box box{{low, 0}, {high, 1}, {true, false}};
      for (const double from : {0.0, 0.1, 0.37}) {
        const Box one{{low + from, 0}, {high + from, 1}, {}};
        const Box two{{low + from, 0}, {2 * high - low + from, 1}, {}};
        for (const double edge : {low, high, low + from, high + from, 0.5 * (low + high)}) {
          for (const double x : {edge, std::nextafter(edge, 9.0), std::nextafter(edge, -9.0), edge - 1e-17,
                                 edge + 1e-9, edge - 1e-9}) {
            for (const auto& [part, count] : {std::pair{one, 1U}, std::pair{two, 2U}}) {
              const Places found = images(box, part, {x, 0.5}, 0);
              EXPECT_EQ(found.size(), count) << low << ' ' << high << ' ' << from << ' ' << x;
              for (const Eigen::Vector2d& place : found) {
                EXPECT_GE(place.x(), part.low.x());
                EXPECT_LT(place.x(), part.high.x());
              }
            }
          }
        }
      }
    }
  }
}

TEST(PeriodicImages, OfAPointInAPartThatIsNoWholeNumberOfPeriods) {
  const Box part{{-1, 0}, {4.5, 3}, {}};
  EXPECT_EQ(images(both, part, {3.5, 1}, 0), (Places{{-0.5, 1}, {3.5, 1}}));
  EXPECT_EQ(images(both, part, {0.25, 1}, 0), (Places{{0.25, 1}, {4.25, 1}}));
  EXPECT_EQ(images(both, part, {1, 1}, 0), (Places{{1, 1}}));
  EXPECT_EQ(images(both, {{1, 1}, {2, 2}, {}}, {3, 1.5}, 0), Places{});
}

TEST(PeriodicImages, TooManyAreAnError) {
  EXPECT_EQ(images(both, {{0, 0}, {400, 300}, {}}, {1, 1}, 0).size(), 10000U);
  EXPECT_THROW(images(both, {{0, 0}, {404, 300}, {}}, {1, 1}, 0), Error);
  EXPECT_THROW(images(both, cell, {1, 1}, 1e300), Error);
}

TEST(PeriodicImages, OfPlacesThatAreTooFarAreNotKnown) {
  EXPECT_EQ(images(both, cell, {4e8 + 1, 1}, 0), (Places{{1, 1}}));
  EXPECT_THROW(images(both, cell, {1e300, 1}, 0), Error);
  EXPECT_THROW(images(both, cell, {1, -1e300}, 0.5), Error);
}

}  // namespace
}  // namespace mikromakro
