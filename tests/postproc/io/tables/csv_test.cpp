// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "io/files/output_file.h"
#include "io/tables/csv_reader.h"
#include "io/tables/csv_writer.h"
#include "io/tables/json.h"
#include "model/error.h"
#include "text_file.h"

namespace mikromakro {
namespace {

TEST(Csv, NumbersComeBackToTheLastBit) {
  Table table;
  table.columns = {{"r", "m", "-", "radius"}, {"v", "m/s", "Latzel2001 Eq. 5", "velocity"}};
  table.rows.resize(2, 2);
  table.rows << 0.1, 1.0 / 3, -2e-300, std::nan("");
  const Folder folder;
  const CsvTable read(folder.write("t.csv", csv_text({{"program", "test"}}, table)));
  EXPECT_EQ(read.names(), (std::vector<std::string>{"r", "v"}));
  EXPECT_EQ(read.column("r")[0], 0.1);
  EXPECT_EQ(read.column("v")[0], 1.0 / 3);
  EXPECT_EQ(read.column("r")[1], -2e-300);
  EXPECT_TRUE(std::isnan(read.column("v")[1]));
  EXPECT_EQ(read.comments(), (std::vector<std::string>{"program: test", "column r [m] (-) radius",
                                                       "column v [m/s] (Latzel2001 Eq. 5) velocity"}));
}

TEST(Csv, EveryNanIsWrittenWithoutSign) {
  EXPECT_EQ(number_text(std::nan("")), "nan");
  EXPECT_EQ(number_text(-std::nan("")), "nan");
}

TEST(OutputFile, LeavesNothingBehindUnlessCommitted) {
  const Folder folder;
  { const OutputFile never(folder.path("a.csv")); }
  EXPECT_TRUE(folder.empty());
  OutputFile(folder.path("a.csv")).commit("text");
  EXPECT_EQ(read_text(folder.path("a.csv")), "text");
  EXPECT_THROW(OutputFile(folder.path("no/such/folder.csv")), Error);
}

// nan, a quotation mark, a line feed, and a byte that is not UTF-8.
TEST(Json, KeepsOrderAndEscapes) {
  Json json = Json::object();
  json["b"] = 0.5;
  json["a\""] = std::string_view("x\n\\");
  json["none"] = std::nan("");
  json["count"] = std::int64_t{3};
  json["list"] = std::vector<double>{1, 2};
  json["bytes"] = "\xff";
  EXPECT_EQ(text_of(json),
            "{\"b\":0.5,\"a\\\"\":\"x\\n\\\\\",\"none\":null,\"count\":3,\"list\":[1.0,2.0],\"bytes\":"
            "\"\xef\xbf\xbd\"}");
}

}  // namespace
}  // namespace mikromakro
