// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/noise/regional_field.h>

namespace pcl_normal_smoothing
{
namespace core
{
float
RegionalField::valueAt (const Eigen::Vector3f& place, float otherwise) const
{
  float sum = 0, weights = 0;
  for (const Region& region : regions) {
    const float x = squaredLength ((place - region.centre) / region.reach) + .5f;
    const float weight = 1 / (x * x * x);
    sum += weight * region.value;
    weights += weight;
  }
  return weights > 0 ? sum / weights : otherwise;
}

std::vector<float>
RegionalField::values () const
{
  std::vector<float> values;
  for (const Region& region : regions)
    values.push_back (region.value);
  return values;
}

RegionalField
RegionalField::inUnit (double unit) const
{
  RegionalField field = *this;
  for (Region& region : field.regions) {
    region.centre = (region.centre.cast<double> () / unit).cast<float> ();
    region.reach = static_cast<float> (region.reach / unit);
  }
  return field;
}
} // namespace core
} // namespace pcl_normal_smoothing
