// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "meshes/mesh_io.h"

/** A square of side 1 in z = 0, its vertices a grid, its normals up. */
pcl_normal_smoothing::tools::Mesh
squareMesh (std::uint32_t side);

/** As an OFF file. */
std::string
asOff (const pcl_normal_smoothing::tools::Mesh& mesh);

/** By the divergence theorem; above 0 where the normals of a closed mesh point outwards. */
double
volumeOf (const pcl_normal_smoothing::tools::Mesh& mesh);
