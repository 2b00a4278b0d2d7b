// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "differences.h"

namespace pcl_normal_smoothing
{
namespace core
{
/** The noise that single lines of a scanner show: what parabolas along them leave of the 8, 12 or 16 nearest points, as far
  * as these lie on one line. Detail between the lines is not in it, nor is what moves a line as a whole.
  * \param[in] of_nodes from nodes on lines to at least 16 nearest points each
  * \return sigma, of the part of the noise that is across the line; infinity where there are too few nodes to tell */
double
noiseAlongLines (const std::vector<Differences>& of_nodes);
} // namespace core
} // namespace pcl_normal_smoothing
