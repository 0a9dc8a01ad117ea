// SPDX-License-Identifier: GPL-2.0-or-later
#include "averaging/kernels/kernel_weight.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <utility>

#include "averaging/kernels/gauss_legendre.h"
#include "model/error.h"

namespace mikromakro {
namespace {

// Maximum number of pieces of a branch vector, each integrated separately. A narrower kernel amounts to the
// centre weight.
constexpr double most_pieces = 1e4;

class KernelShares : public Shares {
 public:
  KernelShares(std::unique_ptr<const PointShares> points, double reach, double longest_piece)
      : points_(std::move(points)), reach_(reach), longest_piece_(longest_piece) {}

  double reach(double /*radius*/) const override { return reach_; }
  void of_disc(const Eigen::Vector2d& centre, double /*radius*/, ShareSums& shares) const override {
    points_->add(centre, 1, shares);
  }
  bool of_places() const override { return true; }
  void of_point(const Eigen::Vector2d& point, ShareSums& shares) const override {
    points_->add(point, 1, shares);
  }
  void of_branch(const Eigen::Vector2d& from, const Eigen::Vector2d& branch,
                 ShareSums& shares) const override {
    static const GaussLegendre<5> rule;
    const double pieces = std::fmax(1, std::ceil(branch.norm() / longest_piece_));
    if (pieces > most_pieces)
      throw bad_input({"--weight"}, "the kernel is much narrower than the discs, which would take hours",
                      fmt::format("a width of {:.2g} m or more", branch.norm() / most_pieces),
                      fmt::format("one that divides a branch vector into {:.3g} pieces", pieces));
    for (double piece = 0; piece < pieces; ++piece) {
      for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double s = (piece + 0.5 + 0.5 * rule.nodes[i]) / pieces;
        points_->add(from + s * branch, 0.5 * rule.weights[i] / pieces, shares);
      }
    }
  }

 private:
  std::unique_ptr<const PointShares> points_;
  double reach_;  // m
  double longest_piece_;
};

class SlicedPoints : public PointShares {
 public:
  SlicedPoints(const Volumes& volumes, double radius) : volumes_(volumes), radius_(radius) {}
  void add(const Eigen::Vector2d& point, double factor, ShareSums& shares) const override {
    std::vector<Share> slices;
    volumes_.slice(point, radius_, slices);
    for (const Share& slice : slices) shares.add(slice.volume, factor * slice.weight);
  }

 private:
  const Volumes& volumes_;
  double radius_;
};

double width_of(const std::string& name, const std::string& width) {
  char* end = nullptr;
  const double value = std::strtod(width.c_str(), &end);
  if (width.empty() || *end != '\0' || !(value > 0) || !std::isfinite(value))
    throw bad_input({"--weight"}, "not the width of a kernel", name + ":W with a number W > 0 in m",
                    in_quotes(width));
  return value;
}

}  // namespace

std::unique_ptr<const Shares> KernelWeight::in(const Volumes& volumes) const {
  return std::make_unique<const KernelShares>(volumes.point_shares(kernel_),
                                              kernel_->reach() * kernel_->width(),
                                              kernel_->branch_piece() * kernel_->width());
}

std::unique_ptr<const Shares> TopHatWeight::in(const Volumes& volumes) const {
  return std::make_unique<const KernelShares>(std::make_unique<const SlicedPoints>(volumes, radius_), radius_,
                                              0.5 * radius_);
}

std::unique_ptr<const Weight> make_kernel_weight(const std::string& name) {
  const auto colon = name.find(':');
  const std::string kind = name.substr(0, colon);
  if (kind != "gauss" && kind != "lucy" && kind != "wendland" && kind != "tophat") return nullptr;
  const double width = width_of(kind, colon == name.npos ? "" : name.substr(colon + 1));
  if (kind == "tophat") return std::make_unique<const TopHatWeight>(width);
  std::unique_ptr<const Kernel> kernel;
  if (kind == "gauss") kernel = std::make_unique<const GaussKernel>(width);
  if (kind == "lucy") kernel = std::make_unique<const PolynomialKernel>(lucy(), width);
  if (kind == "wendland") kernel = std::make_unique<const PolynomialKernel>(wendland(), width);
  return std::make_unique<const KernelWeight>(std::move(kernel));
}

}  // namespace mikromakro
