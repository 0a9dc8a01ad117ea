// SPDX-License-Identifier: GPL-2.0-or-later
// What the columns of a contact dump may be called, and that each name acts: a number that is changed under
// it changes the contacts, is refused, or comes out of `convert`.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "io/files/column_map.h"
#include "io/frames/frame_stream.h"
#include "text_file.h"

namespace mikromakro {
namespace {

using Numbers = std::map<std::string, std::string>;

// Discs of radius 0.5 at (1, 1) and (1.54, 1.72), 0.9 apart along n = (0.6, 0.8), t = (-0.8, 0.6): overlap
// 0.1, f = -10 n + 1 t; shear = 2e-6 t. Disc 1 touches mesh 0, which lies 0.48 below it.
const std::string particles =
    "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff pp\n0 5\n0 5\n-1 1\n"
    "ITEM: ATOMS id type x y radius\n1 1 1 1 0.5\n2 1 1.54 1.72 0.5\n";
const Numbers of_pair = {{"id1", "1"},          {"id2", "2"},         {"x1", "1"},     {"y1", "1"},
                         {"x2", "1.54"},        {"y2", "1.72"},       {"nx", "0.6"},   {"ny", "0.8"},
                         {"fx", "-6.8"},        {"fy", "-7.4"},       {"fn", "10"},    {"ft", "1"},
                         {"overlap", "0.1"},    {"vn", "3"},          {"vt", "4"},     {"xi", "2e-6"},
                         {"periodic", "0"},     {"dist", "0.9"},      {"z1", "0"},     {"z2", "0"},
                         {"shearx", "-1.6e-6"}, {"sheary", "1.2e-6"}, {"shearz", "0"}, {"fz", "0"},
                         {"ftx", "0"},          {"fty", "0"},         {"ftz", "0"}};

std::string dump(const std::vector<std::string>& names, const Numbers& numbers) {
  std::vector<std::string> row;
  row.reserve(names.size());
  for (const std::string& name : names) row.push_back(name == "-" ? "word" : numbers.at(name));
  std::vector<std::string> columns;
  columns.reserve(row.size());
  for (std::size_t i = 0; i < row.size(); ++i) columns.push_back(fmt::format("c_X[{}]", i + 1));
  return fmt::format(
      "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ENTRIES\n1\nITEM: BOX BOUNDS ff ff pp\n0 5\n0 5\n-1 1\n"
      "ITEM: ENTRIES {}\n{}\n",
      fmt::join(columns, " "), fmt::join(row, " "));
}

struct Given {
  std::vector<std::string> names;
  Numbers numbers = of_pair;
  std::vector<std::string> wall_names = {};
  Numbers wall_numbers = {};
  bool all_columns = false;  ///< as `convert` reads, else as stress, strain and curvature do
  std::vector<std::string> list = {};
};

// The contacts as text, the rows behind them too, or the refusal.
std::string read(const Given& given) {
  const Folder folder;
  FrameSource source;
  source.particle_files = {folder.write("p", particles)};
  if (!given.names.empty()) source.contact_files = {folder.write("c", dump(given.names, given.numbers))};
  if (!given.wall_names.empty())
    source.wall_files = {folder.write("w", dump(given.wall_names, given.wall_numbers))};
  source.contact_columns = given.list.empty() ? given.names : given.list;
  source.wall_columns = given.wall_names;
  if (!given.all_columns)
    source.contacts_needed = column_set(ContactColumn::fx, ContactColumn::fy, ContactColumn::overlap);
  try {
    FrameStream stream(source);
    Frame frame;
    std::string text;
    while (stream.next(frame))
      for (const Contact& contact : frame.contacts)
        text += fmt::format("{} {} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g};", contact.id1, contact.id2,
                            contact.normal.x(), contact.normal.y(), contact.overlap, contact.force.x(),
                            contact.force.y(), contact.spring);
    if (given.all_columns)
      for (const ContactRow& row : stream.raw().contacts.rows)
        text += fmt::format(" {}", fmt::join(row.value, " "));
    return text;
  } catch (const Error& error) {
    return error.what();
  }
}

const std::string right = "1 2 0.6 0.8 0.1 -6.8 -7.4 2e-06;";

// With which other columns the name stands, and what `average` then makes of a number that is changed.
struct Named {
  std::string name;
  std::vector<std::string> beside;
  bool only_converted = false;
};
const Named named[] = {{"id1", {"id2", "fx", "fy", "xi"}},
                       {"id2", {"id1", "fx", "fy", "xi"}},
                       {"x1", {"id1", "id2", "y1", "x2", "y2", "fx", "fy", "xi"}},
                       {"y1", {"id1", "id2", "x1", "x2", "y2", "fx", "fy", "xi"}},
                       {"x2", {"id1", "id2", "x1", "y1", "y2", "fx", "fy", "xi"}},
                       {"y2", {"id1", "id2", "x1", "y1", "x2", "fx", "fy", "xi"}},
                       {"nx", {"id1", "id2", "ny", "fx", "fy", "xi"}},
                       {"ny", {"id1", "id2", "nx", "fx", "fy", "xi"}},
                       {"overlap", {"id1", "id2", "fx", "fy", "xi"}},
                       {"fx", {"id1", "id2", "fy", "xi"}},
                       {"fy", {"id1", "id2", "fx", "xi"}},
                       {"fn", {"id1", "id2", "ft", "xi"}},
                       {"ft", {"id1", "id2", "fn", "xi"}},
                       {"xi", {"id1", "id2", "fx", "fy"}},
                       {"vn", {"id1", "id2", "fx", "fy", "xi"}, true},
                       {"vt", {"id1", "id2", "fx", "fy", "xi"}, true},
                       {"periodic", {"id1", "id2", "fx", "fy", "xi"}},
                       {"dist", {"id1", "id2", "fx", "fy", "xi"}},
                       {"shearx", {"id1", "id2", "fx", "fy", "sheary"}},
                       {"sheary", {"id1", "id2", "fx", "fy", "shearx"}},
                       {"z1", {"id1", "id2", "x1", "y1", "x2", "y2", "z2", "fx", "fy", "xi"}},
                       {"z2", {"id1", "id2", "x1", "y1", "x2", "y2", "z1", "fx", "fy", "xi"}},
                       {"fz", {"id1", "id2", "fx", "fy", "xi"}},
                       {"shearz", {"id1", "id2", "fx", "fy", "shearx", "sheary"}},
                       {"ftx", {"id1", "id2", "fx", "fy", "fty", "xi"}},
                       {"fty", {"id1", "id2", "fx", "fy", "ftx", "xi"}},
                       {"ftz", {"id1", "id2", "fx", "fy", "ftx", "fty", "xi"}}};

TEST(ContactColumns, EveryNameThatIsAcceptedActs) {
  std::set<std::string> tried = {"mesh"};  // of walls, below
  for (const Named& test : named) {
    tried.insert(test.name);
    Given given{test.beside};
    given.names.push_back(test.name);
    EXPECT_EQ(read(given), right) << test.name;
    Numbers changed = of_pair;
    changed.at(test.name) = test.name.starts_with("id") ? "7" : "0.3";
    Given wrong{given.names, changed};
    EXPECT_EQ(read(wrong) == right, test.only_converted) << test.name;
    wrong.all_columns = given.all_columns = true;
    EXPECT_NE(read(wrong), read(given)) << test.name;
  }
  const auto& known = contact_names().known;
  EXPECT_EQ(tried, std::set<std::string>(known.begin(), known.end()));
}

// A column that is given beside others that tell the same is set beside them.
TEST(ContactColumns, ThatTellTheSameTwiceMustAgree) {
  for (const auto& [name, also] : {std::pair<std::string, std::string>{"fn", "ft"}, {"ft", "fn"}}) {
    Given given{{"id1", "id2", "nx", "ny", "overlap", "fx", "fy", "xi", also, name}};
    EXPECT_EQ(read(given), right);
    given.numbers.at(name) = "2";
    EXPECT_NE(read(given).find("is not that of fx fy"), std::string::npos) << read(given);
    given.names.erase(given.names.end() - 2);
    EXPECT_NE(read(given).find("is not that of fx fy"), std::string::npos) << read(given);
  }
}

TEST(ContactColumns, ThatTellNothingAloneAreRefused) {
  for (const std::string name :
       {"nx", "ny", "x1", "y2", "z1", "shearx", "sheary", "shearz", "ftx", "fty", "ftz"}) {
    const std::string text = read({{"id1", "id2", "fx", "fy", name}});
    EXPECT_NE(text.find("columns are missing (name them with --contact-columns)"), std::string::npos) << text;
  }
  EXPECT_NE(read({{"id1", "id2", "fn", "ft", "fz"}}).find("expected fx fy"), std::string::npos);
  EXPECT_NE(read({{"id1", "id2", "fx", "fy", "xi", "shearx", "sheary"}}).find("twice"), std::string::npos);
}

TEST(ContactColumns, PresetsKnowTheComputesOfTheEnginesByTheirNumberOfColumns) {
  const std::vector<std::string> place = {"x1", "y1", "z1", "x2", "y2", "z2"},
                                 id = {"id1", "id2", "periodic"}, force = {"fx", "fy", "fz"},
                                 shear = {"shearx", "sheary", "shearz"}, skip(3, "-");
  const auto joined = [](const std::vector<std::vector<std::string>>& parts) {
    std::vector<std::string> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
  };
  const std::string without_spring = "1 2 0.6 0.8 0.1 -6.8 -7.4 nan;";
  const auto by = [](const std::string& preset, const std::vector<std::string>& names) {
    return read({names, of_pair, {}, {}, false, {preset}});
  };
  EXPECT_EQ(by("liggghts", joined({place, skip, skip, id, force, skip, shear, {"-"}})), right);
  EXPECT_EQ(by("liggghts", joined({place, skip, skip, id, force, skip, {"-"}})), without_spring);
  EXPECT_EQ(by("liggghts", joined({place, id, force})), without_spring);
  EXPECT_EQ(by("liggghts", joined({place, id, force, {"overlap"}})), without_spring);
  EXPECT_EQ(by("liggghts", joined({place, id, force, shear})), right);
  EXPECT_EQ(by("liggghts", joined({place, id, force, shear, {"overlap"}})), right);
  EXPECT_EQ(by("liggghts", joined({id, force})), without_spring);
  EXPECT_NE(by("liggghts", joined({place, id})).find("expected 6, 12, 13, 15, 16, 22 or 25 columns, got 9"),
            std::string::npos);
  EXPECT_EQ(by("lammps", {"id1", "id2", "dist", "fx", "fy"}), without_spring);
  EXPECT_EQ(by("lammps", {"id1", "id2", "dist", "-", "fx", "fy", "fz"}), without_spring);
  EXPECT_NE(by("lammps", {"id1", "id2", "fx", "fy"}).find("5 or 7 to 17 columns, got 4"), std::string::npos);
  // A column of another kind in the place of one that is checked does not pass.
  EXPECT_NE(by("lammps", {"id1", "id2", "fx", "fy", "fz"}), without_spring);
}

// pair/local's fx fy are those of the normal force, p1 p2 p3 the tangential one: -10 n, and 1 t.
TEST(ContactColumns, TheGranularStylesOfLammpsTellTangentialForcesApart) {
  Given given{{"id1", "id2", "dist", "-", "fx", "fy", "fz", "ftx", "fty", "ftz", "-"}, of_pair};
  given.numbers["fx"] = "-6";
  given.numbers["fy"] = "-8";
  given.numbers["ftx"] = "-0.8";
  given.numbers["fty"] = "0.6";
  given.list = {"lammps"};
  EXPECT_EQ(read(given), "1 2 0.6 0.8 0.1 -6.8 -7.4 nan;");
}

TEST(ContactColumns, RowsOfMeshesAreWalls) {
  const std::vector<std::string> names = {"x2",   "y2", "z2",  "x1", "y1", "z1",
                                          "mesh", "-",  "id1", "fx", "fy", "fz"};
  const Numbers at_mesh = {{"x2", "1"},   {"y2", "0.52"}, {"z2", "0"}, {"x1", "1"}, {"y1", "1"}, {"z1", "0"},
                           {"mesh", "0"}, {"id1", "1"},   {"fx", "0"}, {"fy", "2"}, {"fz", "0"}};
  const std::string wall = "1 -1001 0 -1 0.02 0 2 nan;";
  EXPECT_EQ(read({{}, {}, names, at_mesh}), wall);
  // Beside the rows of discs, which have other columns.
  EXPECT_EQ(read({{"id1", "id2", "nx", "ny", "overlap", "fx", "fy", "xi"}, of_pair, names, at_mesh}),
            right + wall);
  for (const auto& [name, number] :
       Numbers{{"mesh", "2"}, {"id1", "2"}, {"x2", "1.1"}, {"y1", "1.1"}, {"z2", "0.3"}}) {
    Numbers changed = at_mesh;
    changed[name] = number;
    EXPECT_NE(read({{}, {}, names, changed}), wall) << name;
  }
}

}  // namespace
}  // namespace mikromakro
