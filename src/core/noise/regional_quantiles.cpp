// SPDX-License-Identifier: BSD-3-Clause
#include "regional_quantiles.h"

#include "../quantile.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <tuple>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
using Sample = std::vector<LocalValue>;

/** Halves the sample along its longest side, recursively. */
class RegionFinder
{
public:
  RegionFinder (Sample sample, float spacing, double level, std::size_t region_size)
  : sample_ (std::move (sample)), spacing_ (spacing), level_ (level), region_size_ (region_size)
  {
    split (0, sample_.size ());
  }

  const std::vector<RegionalField::Region>&
  regions () const
  {
    return regions_;
  }

private:
  void
  split (std::size_t begin, std::size_t end)
  {
    Eigen::AlignedBox3f box;
    for (std::size_t i = begin; i < end; ++i)
      box.extend (sample_[i].place);
    if (end - begin < 2 * region_size_)
      return add (begin, end, box);
    int axis;
    box.sizes ().maxCoeff (&axis);
    const std::size_t middle = (begin + end) / 2;
    const auto at = [this] (std::size_t i) { return sample_.begin () + static_cast<std::ptrdiff_t> (i); };
    const auto key = [axis] (const LocalValue& point) { // complete, so that the order of the cloud does not matter
      const Eigen::Vector3f& place = point.place;
      return std::make_tuple (place[axis], place.x (), place.y (), place.z (), point.value);
    };
    std::nth_element (at (begin), at (middle), at (end),
                      [&] (const LocalValue& a, const LocalValue& b) { return key (a) < key (b); });
    split (begin, middle);
    split (middle, end);
  }

  void
  add (std::size_t begin, std::size_t end, const Eigen::AlignedBox3f& box)
  {
    std::vector<float> values;
    for (std::size_t i = begin; i < end; ++i)
      values.push_back (sample_[i].value);
    // Copies of a point have no extent.
    const float reach = std::max (box.diagonal ().norm () / 2, spacing_);
    regions_.push_back ({box.center (), reach, quantile (values, level_)});
  }

  Sample sample_;
  float spacing_;
  double level_;
  std::size_t region_size_;
  std::vector<RegionalField::Region> regions_;
};
} // namespace

RegionalField
regionalQuantiles (std::vector<LocalValue> sample, float spacing, double level, std::size_t region_size)
{
  return {RegionFinder (std::move (sample), spacing, level, region_size).regions ()};
}
} // namespace core
} // namespace pcl_normal_smoothing
