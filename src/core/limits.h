// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcl_normal_smoothing
{
namespace core
{
/** Number of entries of a row, the node included, that kernels and rounds use: the first, which are the nearest. */
constexpr std::size_t max_row_length = 32;

/** Points needed to fit a quadric: one more than its coefficients. */
constexpr int min_fit_points = 7;

/** For the presets default and fast. */
constexpr int max_rounds = 6;
} // namespace core
} // namespace pcl_normal_smoothing
