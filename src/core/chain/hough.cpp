// SPDX-License-Identifier: BSD-3-Clause
#include "../kernels.h"
#include <pcl_normal_smoothing/core/chain/hough.h>
#include <pcl_normal_smoothing/core/error.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>

namespace pcl_normal_smoothing
{
namespace core
{
namespace
{
constexpr auto pi = static_cast<float> (M_PI);
constexpr float least_tolerance = 0.001f; // at this, some million triples are drawn per point

// Triples are listed up to this number: among more, few would be drawn twice.
constexpr std::size_t most_listed = 1u << 16;

using RowMajorMatrix = Eigen::Matrix<float, 3, 3, Eigen::RowMajor>;
using Triple = std::array<std::uint32_t, 3>;

/** SplitMix64 (Steele et al. 2014): one stream per point, seeded from its coordinates. */
class RandomStream
{
public:
  /** \param[in] base, offset of the point, as in Positions */
  RandomStream (std::uint64_t seed, const Eigen::Vector3f& base, const Eigen::Vector3f& offset) : state_ (seed)
  {
    mix (base);
    if (offset != Eigen::Vector3f (0, 0, 0)) // far from the origin, many points in double precision share a base
      mix (offset);
  }

  std::uint64_t
  next ()
  {
    state_ += 0x9E3779B97F4A7C15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }

  /** Uniform in [0, bound). */
  std::uint32_t
  below (std::uint32_t bound)
  {
    return static_cast<std::uint32_t> (((next () >> 32) * bound) >> 32);
  }

private:
  void
  mix (const Eigen::Vector3f& coordinates)
  {
    for (int d = 0; d < 3; ++d) {
      const float coordinate = coordinates[d] + 0.0f; // -0 starts the same stream as 0
      std::uint32_t bits;
      std::memcpy (&bits, &coordinate, sizeof bits);
      state_ = next () ^ bits;
    }
  }

  std::uint64_t state_;
};

std::vector<RowMajorMatrix>
randomRotations (int count, std::uint64_t seed)
{
  RandomStream random (seed, Eigen::Vector3f::Zero (), Eigen::Vector3f::Zero ());
  const auto symmetric = [&] { return static_cast<float> (random.next () >> 40) / (1u << 23) - 1.0f; };
  std::vector<RowMajorMatrix> rotations;
  while (rotations.size () < static_cast<std::size_t> (count)) {
    // A point of the four-dimensional unit ball, normalised, is a uniformly distributed rotation.
    const float w = symmetric (), x = symmetric (), y = symmetric (), z = symmetric ();
    const Eigen::Quaternionf quaternion (w, x, y, z);
    if (quaternion.squaredNorm () > 0.01f && quaternion.squaredNorm () < 1)
      rotations.push_back (quaternion.normalized ().toRotationMatrix ());
  }
  return rotations;
}

void
check (bool valid, const std::string& what, double value, const std::string& range)
{
  if (!valid)
    throw Error ("the " + what + " of the Hough normal estimation is " + numberText (value) + ": give a number " +
                 range);
}
} // namespace

/** Triples of neighbours in random order. If there are at most \a max of them, and at most most_listed, none is
  * repeated between restarts. */
class HoughEstimator::TripleSource
{
public:
  TripleSource (std::uint32_t count, std::size_t max, RandomStream random) : count_ (count), random_ (random)
  {
    if (std::size_t (count) * (count - 1) * (count - 2) / 6 > std::min (max, most_listed))
      return;
    for (std::uint32_t a = 0; a < count; ++a)
      for (std::uint32_t b = a + 1; b < count; ++b)
        for (std::uint32_t c = b + 1; c < count; ++c)
          listed_.push_back ({a, b, c});
  }

  /** Number of triples for one accumulator: its \a share, or all there are if they are listed and fewer. */
  std::size_t
  limit (std::size_t share) const
  {
    return listed_.empty () ? share : std::min (share, listed_.size ());
  }

  /** For the next accumulator: all triples may be drawn again. */
  void
  restart ()
  {
    drawn_ = 0;
  }

  Triple
  next ()
  {
    if (!listed_.empty ()) { // a partial Fisher-Yates shuffle, called at most limit () times
      const std::size_t i = drawn_++;
      std::swap (listed_[i], listed_[i + random_.below (static_cast<std::uint32_t> (listed_.size () - i))]);
      return listed_[i];
    }
    const std::uint32_t a = random_.below (count_);
    std::uint32_t b = random_.below (count_ - 1);
    b += b >= a;
    std::uint32_t c = random_.below (count_ - 2);
    c += c >= std::min (a, b);
    c += c >= std::max (a, b);
    return {a, b, c};
  }

private:
  std::uint32_t count_;
  RandomStream random_;
  std::vector<Triple> listed_;
  std::size_t drawn_ = 0;
};

HoughEstimator::HoughEstimator (const HoughOptions& options) : options_ (options)
{
  check (options.confidence > 0 && options.confidence < 1, "confidence", options.confidence, "between 0 and 1");
  check (options.tolerance >= least_tolerance && options.tolerance < 1, "tolerance", options.tolerance,
         "from 0.001 to below 1");
  check (options.bands >= 2 && options.bands <= 1000, "number of bands", options.bands, "from 2 to 1000");
  check (options.rotations >= 1 && options.rotations <= 1000, "number of rotations", options.rotations,
         "from 1 to 1000");

  const float height = pi / static_cast<float> (options.bands);
  std::size_t bins = 0;
  for (int band = 0; static_cast<float> (band) * height < pi / 2; ++band) {
    const float angle = static_cast<float> (band) * height;
    band_begin_.push_back (static_cast<float> (bins));
    band_cosine_.push_back (std::cos (angle + height / 2));
    bins += std::max<std::size_t> (1, std::lround (2 * static_cast<float> (options.bands) * std::sin (angle)));
  }
  band_begin_.push_back (static_cast<float> (bins));
  const double triples = std::log (2 * static_cast<double> (bins) / (1 - options.confidence)) /
                         (2 * options.tolerance * options.tolerance);
  max_triples_ = static_cast<std::size_t> (std::ceil (triples));
  rotations_ = randomRotations (options.rotations, options.seed);
}

/** The leading bin, and the votes of the second. */
struct HoughEstimator::Ballot
{
  std::size_t best = 0;
  std::uint32_t second_votes = 0;

  void
  cast (std::vector<Bin>& bins, std::size_t index, const Eigen::Vector3f& normal)
  {
    bins[index].sum += normal;
    const std::uint32_t votes = ++bins[index].votes;
    if (index != best && votes > bins[best].votes) {
      second_votes = bins[best].votes;
      best = index;
    }
    else if (index != best)
      second_votes = std::max (second_votes, votes);
  }

  /** Whether the confidence intervals of the first two bins are disjoint: their shares differ by 2 sqrt (1 / T),
    * with T triples drawn. */
  bool
  isDecided (const std::vector<Bin>& bins, std::size_t drawn) const
  {
    const std::size_t lead = bins[best].votes - second_votes;
    return drawn > 0 && lead * lead >= 4 * drawn;
  }
};

LocalSurface
HoughEstimator::estimate (const Neighborhood& neighborhood) const
{
  const LocalSurface pca = pcaSurface (neighborhood);
  if (std::isnan (pca.variation))
    return pca;
  Vectors points;
  float farthest = 0;
  for (std::size_t j = 0; j < neighborhood.size (); ++j) {
    points.push_back (neighborhood[j]);
    farthest = std::max (farthest, points.back ().lpNorm<Eigen::Infinity> ());
  }
  // The votes compute fourth powers.
  const float scale = std::ldexp (1.0f, -std::clamp (std::ilogb (farthest), -100, 100));
  for (Eigen::Vector3f& point : points)
    point *= scale;
  TripleSource triples (static_cast<std::uint32_t> (points.size ()), max_triples_,
                        RandomStream (options_.seed, neighborhood.base (), neighborhood.offset ()));
  std::vector<Bin> bins (binCount ());
  Eigen::Vector3f sum (0, 0, 0);
  for (const RowMajorMatrix& rotation : rotations_) {
    const Eigen::Vector3f winner = vote (rotation, points, triples, bins);
    sum += winner.dot (sum) < 0 ? Eigen::Vector3f (-winner) : winner;
  }
  const float length = sum.norm ();
  return length > 0 ? LocalSurface {sum / length, pca.variation} : LocalSurface::invalid ();
}

Eigen::Vector3f
HoughEstimator::vote (const RowMajorMatrix& rotation,
                      const Vectors& points,
                      TripleSource& triples,
                      std::vector<Bin>& bins) const
{
  std::fill (bins.begin (), bins.end (), Bin ());
  triples.restart ();
  const std::size_t limit = triples.limit ((max_triples_ - 1) / rotations_.size () + 1);
  Ballot ballot;
  std::uint32_t drawn_triples[3][block_size];
  float normals[3][block_size];
  std::int32_t bin_numbers[block_size];
  const PlaneVotes votes {points.data ()->data (),
                          drawn_triples,
                          reinterpret_cast<const float (*)[3]> (rotation.data ()),
                          band_cosine_.data (),
                          band_begin_.data (),
                          static_cast<std::uint32_t> (band_cosine_.size ()),
                          normals,
                          bin_numbers};
  for (std::size_t drawn = 0; drawn < limit && !ballot.isDecided (bins, drawn); drawn += block_size) {
    const std::size_t size = std::min (block_size, limit - drawn);
    for (std::size_t i = 0; i < block_size; ++i) {
      const Triple triple = i < size ? triples.next () : Triple {};
      for (std::size_t corner = 0; corner < 3; ++corner)
        drawn_triples[corner][i] = triple[corner];
    }
    kernels ().vote_planes (votes);
    for (std::size_t i = 0; i < size; ++i)
      if (bin_numbers[i] >= 0)
        ballot.cast (bins, static_cast<std::size_t> (bin_numbers[i]), {normals[0][i], normals[1][i], normals[2][i]});
  }
  return rotation.transpose () * bins[ballot.best].sum.normalized ();
}
} // namespace core
} // namespace pcl_normal_smoothing
