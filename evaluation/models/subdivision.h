// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "meshes/mesh_io.h"

namespace pcl_normal_smoothing::evaluation
{

/** Cuts every triangle into four at the middles of its edges. The vertices stay, with one more for each edge behind
  * them, in the order in which the triangles come to their edges. */
void
subdivide (tools::Mesh& mesh);

} // namespace pcl_normal_smoothing::evaluation
