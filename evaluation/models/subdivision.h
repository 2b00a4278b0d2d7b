// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "meshes/mesh_io.h"

namespace pcl_normal_smoothing::evaluation
{

/** Splits every triangle into four at the midpoints of its edges. The old vertices stay, followed by one new vertex per
  * edge, in the order in which the edges first occur in the triangles. */
void
subdivide (tools::Mesh& mesh);

} // namespace pcl_normal_smoothing::evaluation
