// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkLookupTable.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace pcl_normal_smoothing
{
namespace tools
{
/** From light grey, in which the light on a surface shows, over yellow to dark red. NaN is blue. */
vtkSmartPointer<vtkLookupTable>
makeColours ();

/** What nineteen of twenty values do not exceed: the end of the scale, as a few points off the surface would take it
  * all. Values that are not finite do not count; above 0. */
double
scaleLimit (std::vector<float> values);

double
meanOfFinite (const std::vector<float>& values);

double
largestFinite (const std::vector<float>& values);
} // namespace tools
} // namespace pcl_normal_smoothing
