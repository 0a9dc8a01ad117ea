// SPDX-License-Identifier: GPL-2.0-or-later
// HDF5 snapshots through the program.
#include <gtest/gtest.h>

#include <algorithm>

#include "run_program.h"

namespace mikromakro {
namespace {

const std::string dumps = "--particles good/particles.dump --contacts good/contacts.dump ";
const std::string rings = " --rings 0 4 2 --bulk-types 1";

std::string numbers(const std::string& csv) {
  return csv.substr(csv.find("\nr_inner"));
}

TEST(Convert, AveragesOfSnapshotsAreThoseOfTheDumpsToTheLastBit) {
  const Folder folder;
  const std::string file = std::string("'").append(folder.path("s.h5")).append("'");
  const Ran ran = run_program("convert " + dumps + "--timestep 0.01 --out " + file);
  EXPECT_EQ(ran.code, 0) << ran.err;
  const Ran from_dumps = run_program("average " + dumps + rings);
  const Ran from_file = run_program("average " + file + rings);
  EXPECT_EQ(from_file.code, 0) << from_file.err;
  EXPECT_EQ(numbers(from_file.out), numbers(from_dumps.out));
  EXPECT_NE(run_program("info " + file).out.find("frames   2 (steps 100 to 200)"), std::string::npos);
  EXPECT_EQ(run_program("draw " + file + " --chains --out '" + folder.path("a.png") + "'").code, 0);
}

TEST(Convert, BadFilesGiveOneLineAndNoOutput) {
  const Folder folder;
  const std::string whole = folder.path("s.h5");
  EXPECT_EQ(run_program("convert " + dumps + "--out '" + whole + "'").code, 0);
  const std::string cut = folder.write("cut.h5", read_text(whole).substr(0, 5000));
  for (const std::string& file : {cut, std::string("good/particles.dump"), folder.path("none.h5")}) {
    const Folder outputs;
    const Ran ran = run_program("average '" + file + "'" + rings + " --out '" + outputs.path("a.csv") + "'");
    EXPECT_EQ(ran.code, 2);
    EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    EXPECT_NE(ran.err.find(file), std::string::npos) << ran.err;
    EXPECT_TRUE(outputs.empty());
  }
  const Folder outputs;
  EXPECT_EQ(
      run_program("convert --particles bad/nan_position.dump --out '" + outputs.path("a.h5") + "'").code, 2);
  EXPECT_TRUE(outputs.empty());
}

}  // namespace
}  // namespace mikromakro
