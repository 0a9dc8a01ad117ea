// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/weight.h"

#include <algorithm>
#include <iterator>

#include "averaging/kernels/kernel_weight.h"
#include "model/error.h"
#include "model/nearest_name.h"

namespace mikromakro {
namespace {

class SlicedShares : public Shares {
 public:
  explicit SlicedShares(const Volumes& volumes) : volumes_(volumes) {}
  double reach(double radius) const override { return radius; }
  void of_disc(const Eigen::Vector2d& centre, double radius, ShareSums& shares) const override {
    volumes_.slice(centre, radius, shares.list());
  }

 private:
  const Volumes& volumes_;
};

class CentreShares : public Shares {
 public:
  explicit CentreShares(const Volumes& volumes) : volumes_(volumes) {}
  double reach(double /*radius*/) const override { return 0; }
  void of_disc(const Eigen::Vector2d& centre, double /*radius*/, ShareSums& shares) const override {
    const int volume = volumes_.find(centre);
    if (volume >= 0) shares.list().push_back({volume, 1.0});
  }

 private:
  const Volumes& volumes_;
};

}  // namespace

std::unique_ptr<const Shares> SlicedWeight::in(const Volumes& volumes) const {
  return std::make_unique<const SlicedShares>(volumes);
}

std::unique_ptr<const Shares> CentreWeight::in(const Volumes& volumes) const {
  return std::make_unique<const CentreShares>(volumes);
}

std::unique_ptr<const Weight> make_weight(const std::string& name) {
  if (name == "sliced") return std::make_unique<const SlicedWeight>();
  if (name == "centre") return std::make_unique<const CentreWeight>();
  if (auto kernel = make_kernel_weight(name)) return kernel;
  constexpr std::string_view kinds[] = {"sliced", "centre", "gauss", "lucy", "wendland", "tophat"};
  constexpr auto expected = "sliced, centre, gauss:W, lucy:W, wendland:W or tophat:W with a width W in m";
  const std::string kind = name.substr(0, name.find(':'));
  const bool known = std::find(std::begin(kinds), std::end(kinds), kind) != std::end(kinds);
  throw bad_input({"--weight"}, "unknown weight", expected,
                  known ? in_quotes(name) : in_quotes_with_guess(kind, kinds));
}

}  // namespace mikromakro
