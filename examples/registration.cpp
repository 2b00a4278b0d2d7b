// SPDX-License-Identifier: BSD-3-Clause
// Two noisy scans of one surface are aligned by GICP: the alignment is better if they are smoothed first.
#include <pcl_normal_smoothing/normal_smoothing.h>

#include <pcl/common/transforms.h>
#include <pcl/registration/gicp.h>

#include <iostream>
#include <random>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** Waves over a square of side 2 with noise of 0.01. */
Cloud::Ptr
makeScan (unsigned seed)
{
  std::mt19937 random (seed);
  std::uniform_real_distribution<float> place (-1, 1);
  std::normal_distribution<float> noise (0, 0.01f);
  auto scan = pcl::make_shared<Cloud> ();
  for (int i = 0; i < 5000; ++i) {
    const float x = place (random), y = place (random);
    scan->emplace_back (x, y, 0.1f * std::sin (5 * x) * std::cos (5 * y) + noise (random));
  }
  return scan;
}

Cloud::Ptr
smooth (const Cloud::ConstPtr& scan)
{
  auto smoothed = pcl::make_shared<Cloud> ();
  pcl_normal_smoothing::NormalSmoothing<pcl::PointXYZ> smoothing;
  smoothing.setInputCloud (scan);
  smoothing.filter (*smoothed);
  return smoothed;
}

/** \return root mean square distance of the square's corners, after alignment, from where they belong */
double
alignmentError (const Cloud::ConstPtr& source, const Cloud::ConstPtr& target, const Eigen::Affine3f& motion)
{
  auto moved = pcl::make_shared<Cloud> ();
  pcl::transformPointCloud (*source, *moved, motion);
  pcl::GeneralizedIterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> registration;
  registration.setInputSource (moved);
  registration.setInputTarget (target);
  registration.setMaxCorrespondenceDistance (0.2);
  Cloud aligned;
  registration.align (aligned);
  const Eigen::Affine3f rest (registration.getFinalTransformation () * motion.matrix ());
  double sum = 0;
  for (const float x : {-1.0f, 1.0f})
    for (const float y : {-1.0f, 1.0f})
      sum += (rest * Eigen::Vector3f (x, y, 0) - Eigen::Vector3f (x, y, 0)).squaredNorm () / 4;
  return std::sqrt (sum);
}

int
main ()
{
  const Eigen::Affine3f motion =
      Eigen::Translation3f (0.03f, -0.02f, 0.02f) * Eigen::AngleAxisf (0.03f, Eigen::Vector3f (1, 2, 3).normalized ());
  double before = 0, after = 0;
  constexpr unsigned pairs = 4;
  for (unsigned pair = 0; pair < pairs; ++pair) {
    const Cloud::ConstPtr source = makeScan (2 * pair), target = makeScan (2 * pair + 1);
    before += alignmentError (source, target, motion) / pairs;
    after += alignmentError (smooth (source), smooth (target), motion) / pairs;
  }
  std::cout << "alignment error of GICP: " << before << " raw, " << after << " smoothed\n";
  return after < 0.8 * before ? 0 : 1;
}
