// SPDX-License-Identifier: GPL-2.0-or-later
// Restart files in the middle of contacts that stick and slide: springs and settings of the law survive.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "engine.h"
#include "engine/engine_access.h"
#include "law/disc_law.h"

namespace mikromakro::test {
namespace {

using physics::Effects;
using physics::Normal;
using physics::Tangential;

constexpr double a = 5e-3;

struct Law {
  const char* pair_style;
  double k_n;  // [N/m], of Hertz's law [N/m^2]
  Effects effects;
};
void PrintTo(const Law& law, std::ostream* out) {
  *out << law.pair_style;
}
const Law laws[] = {{"model disc/linear tangential disc/cundall_strack tangential_damping on limitForce on",
                     352.1,
                     {Tangential::damped_spring, true, Normal::linear, true}},
                    {"model disc/hertz tangential disc/cundall_strack damping off impact_velocity 0.1",
                     4e5,
                     {Tangential::spring, false, Normal::hertz, false}}};

class RestartInContact : public testing::TestWithParam<Law> {
 protected:
  // The first rank names the file.
  RestartInContact() {
    int number = getpid();
    MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
    file_ = testing::TempDir() + "contact" + std::to_string(number) + ".restart";
  }
  ~RestartInContact() override { std::filesystem::remove(file_); }

  /// Disc 2 slides on disc 1, disc 4 sticks to disc 3; the border of two ranks is at x = 0.
  void start() {
    engine_.run(scene(GetParam().pair_style, material_, 0.05, 1));
    engine_.run(disc(1, -a, 0, a) + disc(2, a - 2e-4, 0, a) + disc(3, -a, 0.03, a) +
                disc(4, a - 2e-4, 0.03, a));
    engine_.run(motion(2, 0, 0.3) + motion(4, 0, 2e-3) + in_motion_ + "run 40\n");
    contacts_ = engine_.contacts();
    ASSERT_NEAR(std::abs(contacts_.at({1, 2}).f_t), material_.mu * contacts_.at({1, 2}).f_n, 1e-12);
    ASSERT_LT(std::abs(contacts_.at({3, 4}).f_t), 0.9 * material_.mu * contacts_.at({3, 4}).f_n);
    engine_.run("write_restart " + file_ + "\nrun 0\n");
    contacts_ = engine_.contacts();
    engine_.run("run 40\n");
    later_ = engine_.contacts();
  }

  void restart(const std::string& pair_style) {
    engine_.run("clear\nnewton off\ncommunicate single vel yes\natom_modify map array\nread_restart " +
                file_ + "\n");
    engine_.run("neighbor 0.001 bin\nneigh_modify delay 0\n" + constants(material_, 1) + pair_style +
                in_motion_);
  }

  static void expect_equal(const std::map<std::pair<int, int>, Contact>& one,
                           const std::map<std::pair<int, int>, Contact>& other) {
    ASSERT_EQ(one.size(), other.size());
    for (const auto& [ids, contact] : one) {
      const auto& again = other.at(ids);
      // The same arithmetic on the same numbers: no tolerance.
      EXPECT_EQ(contact.xi, again.xi);
      EXPECT_EQ(contact.f_n, again.f_n);
      EXPECT_EQ(contact.f_t, again.f_t);
      EXPECT_EQ(contact.overlap, again.overlap);
    }
  }

  void expect_to_go_on() {
    const auto effects = styles::active_disc_law(engine_.lammps())->effects();
    EXPECT_EQ(effects, GetParam().effects);
    engine_.run("run 0\n");
    expect_equal(contacts_, engine_.contacts());
    engine_.run("run 40\n");
    expect_equal(later_, engine_.contacts());
  }

  Material material_{.k_n = GetParam().k_n, .gamma_t = 0.01};
  std::string in_motion_ = "fix integrate all nve/disc\ncompute contacts all contact/disc\ntimestep 2e-5\n";
  std::string file_;
  Engine engine_;
  std::map<std::pair<int, int>, Contact> contacts_, later_;
};

TEST_P(RestartInContact, KeepsSpringAndSettingsWithoutThePairStyle) {
  ASSERT_NO_FATAL_FAILURE(start());
  restart("");
  expect_to_go_on();
}

TEST_P(RestartInContact, KeepsTheSpringWhereThePairStyleIsGivenAgain) {
  ASSERT_NO_FATAL_FAILURE(start());
  restart(std::string("pair_style gran ") + GetParam().pair_style + "\npair_coeff * *\n");
  expect_to_go_on();
}

INSTANTIATE_TEST_SUITE_P(OfEachLaw, RestartInContact, testing::ValuesIn(laws),
                         [](const auto& info) { return "law_" + std::to_string(info.index); });

std::map<std::pair<int, int>, Contact> contacts_after(const std::string& runs) {
  Engine engine;
  engine.run(scene("model disc/linear tangential disc/cundall_strack", {.gamma_n = 0}, 0.05, 1));
  engine.run(disc(1, -a, 0, a) + disc(2, a - 2e-4, 0, a) + motion(2, 0, 0.05));
  engine.run("fix integrate all nve/disc\ncompute contacts all contact/disc\ntimestep 2e-5\n" + runs);
  return engine.contacts();
}

TEST(SetUpOfARun, NeitherMovesTheSpringNorForgetsTheSlip) {
  // Without dashpots the set-up repeats the forces of the last step, so that a run may be cut: no tolerance.
  const auto whole = contacts_after("run 40\n").at({1, 2}),
             cut = contacts_after("run 20\nrun 20\n").at({1, 2});
  ASSERT_NE(whole.xi, 0);
  EXPECT_EQ(whole.xi, cut.xi);
  EXPECT_EQ(whole.f_t, cut.f_t);
  EXPECT_EQ(whole.overlap, cut.overlap);
}

}  // namespace
}  // namespace mikromakro::test
