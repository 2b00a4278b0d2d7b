// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "differences.h"

namespace pcl_normal_smoothing
{
namespace core
{
/** The noise along single lines of a scanner: the residual of parabolas through the 8, 12 or 16 nearest points, as far
  * as these lie on one line. It contains no detail between lines, and nothing that shifts a line as a whole.
  * \param[in] of_nodes from nodes on lines to at least 16 nearest points each
  * \return sigma of the noise across the line; infinity if there are too few nodes */
double
noiseAlongLines (const std::vector<Differences>& of_nodes);
} // namespace core
} // namespace pcl_normal_smoothing
