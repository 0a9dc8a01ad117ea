// SPDX-License-Identifier: GPL-2.0-or-later
// Shares of points in rectangles.
#pragma once

#include <memory>
#include <vector>

#include "averaging/kernels/kernel.h"
#include "averaging/shares.h"

namespace mikromakro {

/// Integral of a kernel about a point over each of the rectangles between successive edges along x and y (m,
/// ascending; x varies fastest), to 1e-11: a product of error functions for Gauss, else closed-form sweeps
/// along the sides. Never throws.
std::unique_ptr<const PointShares> grid_kernel(std::shared_ptr<const Kernel> kernel,
                                               std::vector<double> x_edges, std::vector<double> y_edges);

}  // namespace mikromakro
