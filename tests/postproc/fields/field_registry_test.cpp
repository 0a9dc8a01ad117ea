// SPDX-License-Identifier: GPL-2.0-or-later
#include "fields/field_registry.h"

#include <gtest/gtest.h>

#include "model/error.h"

namespace mikromakro {
namespace {

TEST(FieldRegistry, SourcesAreAveragedButNotShown) {
  const FieldList fields = make_fields({"stiffness"});
  ASSERT_EQ(fields.size(), 3U);
  EXPECT_EQ(fields[0].field->name(), "stress");
  EXPECT_EQ(fields[1].field->name(), "elastic_strain");
  EXPECT_FALSE(fields[0].shown || fields[1].shown);
  EXPECT_TRUE(fields[2].shown);
}

TEST(FieldRegistry, FieldWithoutItsOptionIsAnError) {
  EXPECT_THROW(make_fields({"sliding_fraction"}), Error);
  EXPECT_THROW(make_fields({"contact_angle_histogram"}), Error);
  for (const ListedField& listed : make_fields({"all"})) EXPECT_TRUE(listed.field->missing_option().empty());
}

}  // namespace
}  // namespace mikromakro
