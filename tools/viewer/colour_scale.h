// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** From light grey, on which shading is visible, through yellow to dark red. NaN is blue. */
vtkSmartPointer<vtkLookupTable>
makeColours ();

/** The end of the scale: the 95th percentile of the finite values, as a few points off the surface would otherwise
  * take up all of it. Above 0. */
double
scaleLimit (std::vector<float> values);

double
meanOfFinite (const std::vector<float>& values);

double
largestFinite (const std::vector<float>& values);
} // namespace tools
} // namespace pcl_normal_smoothing
