// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "models/model.h"

namespace pcl_normal_smoothing::evaluation
{

/** Reads a mesh; the model is named after the file, without extension. Triangles of zero area and vertices without a
  * triangle are left out, which model.source records. A mesh far from the origin is moved there, as clouds are kept in
  * float. The mesh may have holes.
  * \param[in] subdivisions number of times that all edges are split at their midpoints
  * \throw FileError if it cannot be read or is no mesh, core::Error if too few vertices remain */
Model
loadModel (const std::string& path, int subdivisions);

/** The file's name without folder and extension, which loadModel uses as the model's name. */
std::string
modelName (const std::string& path);

} // namespace pcl_normal_smoothing::evaluation
