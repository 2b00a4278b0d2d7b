// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "meshes/mesh_io.h"

/** A square of side 1 in the plane z = 0, with a grid of \a side x \a side vertices and upward normals. */
pcl_normal_smoothing::tools::Mesh
squareMesh (std::uint32_t side);

/** The text of an OFF file. */
std::string
asOff (const pcl_normal_smoothing::tools::Mesh& mesh);

/** Volume by the divergence theorem; positive if the normals of a closed mesh point outwards. */
double
volumeOf (const pcl_normal_smoothing::tools::Mesh& mesh);
