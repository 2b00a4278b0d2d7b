// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_normal_smoothing
{
namespace core
{
/** The usual distance between neighbouring points over the distance of the eighth nearest: sqrt (pi / 8). */
constexpr double spacing_of_eighth = 0.62665706865775;
} // namespace core
} // namespace pcl_normal_smoothing
