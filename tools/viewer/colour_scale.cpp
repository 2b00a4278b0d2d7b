// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/colour_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace tools
{
vtkSmartPointer<vtkLookupTable>
makeColours ()
{
  using Colour = std::array<double, 3>;
  const std::array<Colour, 4> stops {Colour {0.86, 0.87, 0.89}, Colour {0.98, 0.80, 0.35}, Colour {0.90, 0.40, 0.13},
                                     Colour {0.55, 0.05, 0.15}};
  constexpr int size = 256;
  auto table = vtkSmartPointer<vtkLookupTable>::New ();
  table->SetNumberOfTableValues (size);
  for (int i = 0; i < size; ++i) {
    const double at = static_cast<double> (i) / (size - 1) * (stops.size () - 1);
    const auto stop = std::min (static_cast<std::size_t> (at), stops.size () - 2);
    const double share = at - static_cast<double> (stop);
    Colour colour;
    for (std::size_t c = 0; c < 3; ++c)
      colour[c] = (1 - share) * stops[stop][c] + share * stops[stop + 1][c];
    table->SetTableValue (i, colour[0], colour[1], colour[2]);
  }
  table->SetNanColor (0.35, 0.55, 0.85, 1);
  return table;
}

double
scaleLimit (std::vector<float> values)
{
  values.erase (std::remove_if (values.begin (), values.end (), [] (float v) { return !std::isfinite (v); }),
                values.end ());
  if (values.empty ())
    return 1;
  const auto place = values.begin () + static_cast<std::ptrdiff_t> (values.size () * 19 / 20);
  std::nth_element (values.begin (), place, values.end ());
  return *place > 0 ? *place : 1;
}

double
meanOfFinite (const std::vector<float>& values)
{
  double sum = 0, count = 0;
  for (const float value : values)
    if (std::isfinite (value)) {
      sum += value;
      ++count;
    }
  return count > 0 ? sum / count : 0;
}

double
largestFinite (const std::vector<float>& values)
{
  float largest = 0;
  for (const float value : values)
    if (std::isfinite (value))
      largest = std::max (largest, value);
  return largest;
}
} // namespace tools
} // namespace pcl_normal_smoothing
