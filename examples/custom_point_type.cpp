// SPDX-License-Identifier: BSD-3-Clause
// A custom point type: the library is not compiled for it, so its templates come from the impl headers.
#define PCL_NO_PRECOMPILE
#include <pcl_normal_smoothing/normal_smoothing.h>

#include <pcl/register_point_struct.h>

#include <iostream>
#include <random>

struct EIGEN_ALIGN16 LidarPoint
{
  PCL_ADD_POINT4D;
  float intensity;
  std::uint16_t ring;
  double time_s;
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

// clang-format off
POINT_CLOUD_REGISTER_POINT_STRUCT (LidarPoint,
                                   (float, x, x) (float, y, y) (float, z, z) (float, intensity, intensity)
                                   (std::uint16_t, ring, ring) (double, time_s, time_s))
// clang-format on

using Cloud = pcl::PointCloud<LidarPoint>;

/** A cylinder of radius 1 about the z axis with noise of 0.005. */
Cloud::Ptr
makeScan ()
{
  std::mt19937 random (1);
  std::normal_distribution<float> noise (0, 0.005f);
  auto cloud = pcl::make_shared<Cloud> ();
  for (int i = 0; i < 20000; ++i) {
    const float angle = static_cast<float> (i % 200) * 0.0314159f, radius = 1 + noise (random);
    LidarPoint point {};
    point.getVector4fMap () << radius * std::cos (angle), radius * std::sin (angle),
        0.03f * static_cast<float> (i / 200), 1;
    point.ring = static_cast<std::uint16_t> (i / 200);
    point.time_s = 1e-5 * i;
    cloud->push_back (point);
  }
  return cloud;
}

double
meanDistanceToCylinder (const Cloud& cloud)
{
  double sum = 0;
  for (const LidarPoint& point : cloud)
    sum += std::abs (std::hypot (point.x, point.y) - 1);
  return sum / static_cast<double> (cloud.size ());
}

int
main ()
{
  const Cloud::Ptr noisy = makeScan ();
  Cloud smoothed;
  pcl_normal_smoothing::NormalSmoothing<LidarPoint> smoothing;
  smoothing.setInputCloud (noisy);
  smoothing.setKSearch (15);
  smoothing.filter (smoothed);

  const double before = meanDistanceToCylinder (*noisy), after = meanDistanceToCylinder (smoothed);
  std::cout << "mean distance to the cylinder: " << before << " before, " << after << " after\n";
  bool kept = smoothed.size () == noisy->size ();
  for (std::size_t i = 0; kept && i < smoothed.size (); ++i)
    kept = smoothed[i].ring == (*noisy)[i].ring && smoothed[i].time_s == (*noisy)[i].time_s;
  return kept && after < 0.6 * before ? 0 : 1;
}
