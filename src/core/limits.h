// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcl_normal_smoothing
{
namespace core
{
/** How many nodes of a row, itself counted, kernels and rounds look at: the first ones, the nearest. */
constexpr std::size_t max_row_length = 32;

/** Points that a quadric needs: one more than it has coefficients. */
constexpr int min_fit_points = 7;

/** Of the presets default and fast. */
constexpr int max_rounds = 6;
} // namespace core
} // namespace pcl_normal_smoothing
