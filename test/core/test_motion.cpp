// SPDX-License-Identifier: BSD-3-Clause
#include "smoothed.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pcl_normal_smoothing;
using namespace test_support;

struct MethodCase
{
  std::string name;
  NormalSource source;
  NormalWeight weight;
  UpdateRule rule;
  bool in_rounds = false;
  std::uint32_t k = 12;
};

void
PrintTo (const MethodCase& test, std::ostream* out)
{
  *out << test.name;
}

/** All estimators, weights, both updates and the rounds: results must not depend on position, orientation or scale. */
class MotionTest : public testing::TestWithParam<MethodCase>
{
protected:
  static core::SmoothingOptions
  options ()
  {
    core::SmoothingOptions result;
    result.normals = GetParam ().source;
    result.filter.weight = GetParam ().weight;
    result.filter.mixed_threshold = MixedThreshold::RMS;
    result.filter.iterations = 3;
    result.update.rule = GetParam ().rule;
    result.update.sigma_s = 0.1f;
    result.update.iterations = 3;
    result.in_rounds = GetParam ().in_rounds;
    result.rounds.noise = {-1, -1}; // to be estimated
    return result;
  }

  /** Hough draws its triples by the coordinates: elsewhere it draws others, with equally good but different results. */
  static bool
  isRandom ()
  {
    return GetParam ().source == NormalSource::HOUGH;
  }

  /** Smooths the cloud before and after \a motion, and compares the displacements.
    * \param[in] back transforms the displacements back */
  template <typename Motion>
  void
  expectCommutes (const Motion& motion, const Eigen::Matrix3d& back) const
  {
    Vectors moved;
    for (const auto& point : cloud_)
      moved.push_back (motion (point.cast<double> ()).template cast<float> ());
    const Smoothed here = smoothed (asPositions (cloud_), GetParam ().k, options ());
    const Smoothed there = smoothed (asPositions (moved), GetParam ().k, options ());
    double sum_sq = 0, farthest = 0;
    for (std::size_t i = 0; i < cloud_.size (); ++i) {
      const Eigen::Vector3d difference =
          back * there.displacements[i].cast<double> () - here.displacements[i].cast<double> ();
      sum_sq += difference.squaredNorm ();
      farthest = std::max (farthest, difference.norm ());
    }
    if (isRandom ())
      EXPECT_LT (std::sqrt (sum_sq / static_cast<double> (cloud_.size ())), 0.3 * noise);
    else
      EXPECT_LT (farthest, 1e-5 * diagonal (cloud_));
  }

  static constexpr double noise = 0.02;
  const Vectors cloud_ = withNoise (torus (1000, 1, 0.4).points, noise, 70);
};

TEST_P (MotionTest, CommutesWithARigidMotion)
{
  const Eigen::Quaterniond rotation = Eigen::Quaterniond (0.3, -0.5, 0.7, 0.2).normalized ();
  const Eigen::Vector3d translation (1, -2, 0.5);
  expectCommutes ([&] (const Eigen::Vector3d& p) { return Eigen::Vector3d (rotation * p + translation); },
                  rotation.inverse ().toRotationMatrix ());
}

TEST_P (MotionTest, CommutesWithAMirror)
{
  const Eigen::Matrix3d mirror = Eigen::Vector3d (1, -1, 1).asDiagonal ();
  expectCommutes ([&] (const Eigen::Vector3d& p) { return Eigen::Vector3d (mirror * p); }, mirror);
}

TEST_P (MotionTest, CommutesWithScale)
{
  for (const double scale : {1e-3, 1e3, 3e-9, 2e8})
    expectCommutes ([=] (const Eigen::Vector3d& p) { return Eigen::Vector3d (scale * p); },
                    Eigen::Matrix3d::Identity () / scale);
}

TEST_P (MotionTest, FarFromTheOriginItIsTheSame)
{
  Vectors here, there; // kilometres wide, so that float holds both positions exactly
  for (const auto& point : cloud_) {
    here.push_back ((2000 * point).array ().round () / 2);
    there.push_back (here.back () + Eigen::Vector3f (5e6f, 5e6f, -5e6f));
    ASSERT_EQ (there.back () - Eigen::Vector3f (5e6f, 5e6f, -5e6f), here.back ());
  }
  const Smoothed near = smoothed (asPositions (here), GetParam ().k, options ());
  const Smoothed far = smoothed (asPositions (there), GetParam ().k, options ());
  if (!isRandom ()) {
    EXPECT_EQ (far.displacements, near.displacements);
    EXPECT_EQ (far.normals, near.normals);
    return;
  }
  double sum_sq = 0;
  for (std::size_t i = 0; i < here.size (); ++i)
    sum_sq += (far.displacements[i] - near.displacements[i]).squaredNorm ();
  EXPECT_LT (std::sqrt (sum_sq / static_cast<double> (here.size ())), 0.3 * 1000 * noise);
}

TEST_P (MotionTest, DoublesFarFromTheOriginKeepTheirShape)
{
  Positions there;
  for (const auto& point : cloud_) {
    const Eigen::Vector3d place = point.cast<double> () + Eigen::Vector3d (4.5e5, 5e6, 120);
    there.base.push_back (place.cast<float> ());
    there.offset.push_back ((place - there.base.back ().cast<double> ()).cast<float> ());
  }
  const Smoothed near = smoothed (asPositions (cloud_), GetParam ().k, options ());
  const Smoothed far = smoothed (there, GetParam ().k, options ());
  double sum_sq = 0;
  for (std::size_t i = 0; i < cloud_.size (); ++i)
    sum_sq += (far.displacements[i] - near.displacements[i]).squaredNorm ();
  const double rms = std::sqrt (sum_sq / static_cast<double> (cloud_.size ()));
  EXPECT_LT (rms, isRandom () ? 0.3 * noise : 1e-5 * diagonal (cloud_));
}

TEST_P (MotionTest, DoesNotDependOnTheThreadsOrTheOrder)
{
  const Smoothed one = smoothed (asPositions (cloud_), GetParam ().k, options (), {}, 1);
  const auto order = permutation (cloud_.size (), 71);
  for (const unsigned threads : {2u, 4u}) {
    EXPECT_EQ (smoothed (asPositions (cloud_), GetParam ().k, options (), {}, threads).displacements,
               one.displacements);
    const Smoothed other = smoothed (asPositions (shuffled (cloud_, 71)), GetParam ().k, options (), {}, threads);
    for (std::size_t i = 0; i < order.size (); ++i)
      ASSERT_EQ (other.displacements[i], one.displacements[order[i]]) << "point " << order[i];
  }
}

INSTANTIATE_TEST_SUITE_P (
    Methods,
    MotionTest,
    testing::Values (
        MethodCase {"pca_threshold_paper", NormalSource::PCA, NormalWeight::THRESHOLD, UpdateRule::PAPER},
        MethodCase {"pca_gaussian_compensated", NormalSource::PCA, NormalWeight::GAUSSIAN, UpdateRule::COMPENSATED},
        MethodCase {"wpca_gaussian_paper", NormalSource::WPCA, NormalWeight::GAUSSIAN, UpdateRule::PAPER},
        MethodCase {"wpca_mixed_compensated", NormalSource::WPCA, NormalWeight::MIXED, UpdateRule::COMPENSATED},
        MethodCase {"hough_gaussian_compensated", NormalSource::HOUGH, NormalWeight::GAUSSIAN, UpdateRule::COMPENSATED},
        MethodCase {"rounds_12", NormalSource::WPCA, NormalWeight::GAUSSIAN, UpdateRule::COMPENSATED, true},
        MethodCase {"rounds_32", NormalSource::WPCA, NormalWeight::GAUSSIAN, UpdateRule::COMPENSATED, true, 32}),
    [] (const auto& test) { return test.param.name; });
} // namespace
