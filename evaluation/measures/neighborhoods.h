// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clouds/cloud_points.h"

#include <array>

namespace pcl_normal_smoothing::evaluation
{

/** The neighbourhoods of the paper; k counts the point itself. */
constexpr std::array<unsigned, 3> neighborhood_sizes {7, 15, 21};

/** What the neighbourhoods in a cloud tell of its points, all three sizes from one search. */
struct Neighborhoods
{
  /** The surface variation (Pauly et al. 2002) of every point, for each size; NaN where there is none. */
  std::array<std::vector<double>, 3> variations;
  /** The normals by PCA of the 15 nearest, the sign arbitrary; zero where there is none. */
  tools::Points normals;
  /** Distance of every point to the nearest other. */
  std::vector<double> spacings;
};

/** \param[in] points finite */
Neighborhoods
findNeighborhoods (const tools::Points& points);

} // namespace pcl_normal_smoothing::evaluation
