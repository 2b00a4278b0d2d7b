// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/core/noise_field.h>
#include <pcl_normal_smoothing/core/quantile.h>

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <tuple>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
// Points of the sample in a region, twice as many at most: sigma comes out within a tenth.
constexpr std::size_t region_size = 64;
constexpr std::size_t min_regions = 4;
// No region counts for less or more: nothing divides by zero.
constexpr float max_factor = 8;

/** How far regions are apart by chance, as the ratio of the 9th decile to the 1st, and by detail that looks like noise. */
double
spreadByChance (double ratio)
{
  return 1.4 + .04 / std::max (ratio, .04);
}

// So much more, and the field counts in full; in between it counts in part.
constexpr double spread_to_trust = .4;

using Sample = std::vector<LocalNoise>;

/** Splits the sample in halves along its longest side, again and again. */
class RegionFinder
{
public:
  RegionFinder (Sample sample, float spacing) : sample_ (std::move (sample)), spacing_ (spacing)
  {
    split (0, sample_.size ());
  }

  const std::vector<NoiseField::Region>&
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
    if (end - begin < 2 * region_size)
      return add (begin, end, box);
    int axis;
    box.sizes ().maxCoeff (&axis);
    const std::size_t middle = (begin + end) / 2;
    const auto at = [this] (std::size_t i) { return sample_.begin () + static_cast<std::ptrdiff_t> (i); };
    const auto key = [axis] (const LocalNoise& point) { // all of it: the order of the cloud must not tell
      const Eigen::Vector3f& place = point.place;
      return std::make_tuple (place[axis], place.x (), place.y (), place.z (), point.variance);
    };
    std::nth_element (at (begin), at (middle), at (end),
                      [&] (const LocalNoise& a, const LocalNoise& b) { return key (a) < key (b); });
    split (begin, middle);
    split (middle, end);
  }

  void
  add (std::size_t begin, std::size_t end, const Eigen::AlignedBox3f& box)
  {
    std::vector<float> variances;
    for (std::size_t i = begin; i < end; ++i)
      variances.push_back (sample_[i].variance);
    // Copies of a point have no extent.
    const float reach = std::max (box.diagonal ().norm () / 2, spacing_);
    regions_.push_back ({box.center (), reach, std::sqrt (quantile (variances, .5))});
  }

  Sample sample_;
  float spacing_;
  std::vector<NoiseField::Region> regions_;
};

std::vector<float>
factorsOf (const NoiseField& field)
{
  std::vector<float> factors;
  for (const NoiseField::Region& region : field.regions)
    factors.push_back (region.factor);
  return factors;
}

/** 0: the regions differ by chance. */
double
trustIn (const NoiseField& field, double ratio)
{
  const std::vector<float> factors = factorsOf (field);
  const double high = quantile (factors, .9), low = quantile (factors, .1);
  return std::clamp ((high - spreadByChance (ratio) * low) / (spread_to_trust * low + 1e-30), 0.0, 1.0);
}
} // namespace

float
NoiseField::factorAt (const Eigen::Vector3f& place) const
{
  float sum = 0, weights = 0;
  for (const Region& region : regions) {
    const float x = squaredLength ((place - region.centre) / region.reach) + .5f;
    const float weight = 1 / (x * x * x);
    sum += weight * region.factor;
    weights += weight;
  }
  return weights > 0 ? sum / weights : 1;
}

float
NoiseField::smallestFactor () const
{
  const std::vector<float> factors = factorsOf (*this);
  return isEven () ? 1 : *std::min_element (factors.begin (), factors.end ());
}

float
NoiseField::largestFactor () const
{
  const std::vector<float> factors = factorsOf (*this);
  return isEven () ? 1 : *std::max_element (factors.begin (), factors.end ());
}

NoiseField
NoiseField::inUnit (double unit) const
{
  NoiseField field = *this;
  for (Region& region : field.regions) {
    region.centre = (region.centre.cast<double> () / unit).cast<float> ();
    region.reach = static_cast<float> (region.reach / unit);
  }
  return field;
}

NoiseField
estimateNoiseField (const std::vector<LocalNoise>& sample, float spacing, double ratio)
{
  NoiseField field {RegionFinder (sample, spacing).regions ()};
  const auto trust = static_cast<float> (trustIn (field, ratio));
  std::vector<float> factors;
  for (const LocalNoise& point : sample)
    factors.push_back (field.factorAt (point.place));
  const float usual = quantile (factors, .5);
  if (field.regions.size () < min_regions || !(trust > 0) || !(usual > 0))
    return {};
  for (NoiseField::Region& region : field.regions) {
    const float factor = std::clamp (region.factor / usual, 1 / max_factor, max_factor);
    region.factor = 1 + trust * (factor - 1);
  }
  return field;
}

Numbers
varianceFactors (const NoiseField& field, const Positions& positions, const Execution& execution)
{
  Numbers factors;
  if (field.isEven ())
    return factors;
  factors.resize (positions.size ());
  parallelFor (positions.size (), execution.silent (), [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const float factor = field.factorAt (positions.base[i]);
      factors[i] = factor * factor;
    }
  });
  return factors;
}
} // namespace core
} // namespace pcl_normal_smoothing
