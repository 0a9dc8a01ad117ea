// SPDX-License-Identifier: GPL-2.0-or-later
#include "model/id_map.h"

#include <gtest/gtest.h>

#include "joining/joined_rows.h"
#include "model/error.h"

namespace mikromakro {
namespace {

TEST(IdMap, FindsIdsThatAreDenseOrFarApart) {
  for (const std::int64_t far : {std::int64_t{12}, std::int64_t{1} << 40}) {
    const std::vector<Particle> discs = {disc(far, 0, 0, 1), disc(5, 0, 0, 1), disc(7, 0, 0, 1)};
    const IdMap ids(discs);
    EXPECT_EQ(ids.find(far), 0);
    EXPECT_EQ(ids.find(5), 1);
    EXPECT_EQ(ids.find(6), -1);
    EXPECT_EQ(ids.find(1), -1);
    EXPECT_EQ(ids.find(far + 1), -1);
    EXPECT_EQ(ids.duplicate(), -1);
    EXPECT_EQ(IdMap({disc(far, 0, 0, 1), disc(5, 0, 0, 1), disc(5, 0, 0, 1)}).duplicate(), 2);
  }
}

}  // namespace
}  // namespace mikromakro
