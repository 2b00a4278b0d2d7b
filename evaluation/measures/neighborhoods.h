// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "clouds/cloud_points.h"

#include <array>

namespace pcl_normal_smoothing::evaluation
{

/** The neighbourhoods of the paper; k counts the point itself. */
constexpr std::array<unsigned, 3> neighborhood_sizes {7, 15, 21};

/** Properties of the points' neighbourhoods in a cloud; all three sizes come from one search. */
struct Neighborhoods
{
  /** The surface variation (Pauly et al. 2002) of every point, for each size; NaN where undefined. */
  std::array<std::vector<double>, 3> variations;
  /** The PCA normals of the 15 nearest points, with arbitrary signs; zero where undefined. */
  tools::Points normals;
  /** Distance of every point to the nearest other point. */
  std::vector<double> spacings;
};

/** \param[in] points finite */
Neighborhoods
findNeighborhoods (const tools::Points& points);

} // namespace pcl_normal_smoothing::evaluation
