#include "averaging/weight.h"

#include "io/error.h"

namespace mikromakro {

void SlicedWeight::shares(const Volumes& volumes, const Eigen::Vector2d& centre, double radius,
                          std::vector<Share>& shares) const {
  shares.clear();
  volumes.slice(centre, radius, shares);
}

void CentreWeight::shares(const Volumes& volumes, const Eigen::Vector2d& centre, double /*radius*/,
                          std::vector<Share>& shares) const {
  shares.clear();
  const int volume = volumes.find(centre);
  if (volume >= 0) shares.push_back({volume, 1.0});
}

std::unique_ptr<const Weight> make_weight(const std::string& name) {
  if (name == "sliced") return std::make_unique<const SlicedWeight>();
  if (name == "centre") return std::make_unique<const CentreWeight>();
  throw bad_input({"--weight"}, "unknown weight", "sliced or centre", in_quotes(name));
}

}  // namespace mikromakro
