// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "models/model.h"

namespace pcl_normal_smoothing::evaluation
{

/** Reads a mesh; its name is the file's without extension. Left out, and said so in the source: triangles without an
  * area, and vertices without a triangle. A mesh far from zero is moved there, as the clouds are kept in float. Holes
  * may be.
  * \param[in] subdivisions how often to split the edges in their middles
  * \throw FileError where it cannot be read or is no mesh, core::Error where too little is left of it */
Model
loadModel (const std::string& path, int subdivisions);

/** The file's name without folder and extension, which loadModel takes for the model. */
std::string
modelName (const std::string& path);

} // namespace pcl_normal_smoothing::evaluation
