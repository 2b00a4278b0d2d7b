// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_normal_smoothing/normal_smoothing.h>

#include <iostream>
#include <random>

int
main ()
{
  auto noisy = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> ();
  std::mt19937 random (1);
  std::normal_distribution<float> noise (0, 0.002f);
  for (float x = 0; x < 1; x += 0.01f)
    for (float y = 0; y < 1; y += 0.01f)
      noisy->emplace_back (x, y, noise (random));

  pcl_normal_smoothing::NormalSmoothing<pcl::PointXYZ> smoothing;
  smoothing.setInputCloud (noisy);
  pcl::PointCloud<pcl::PointXYZ> smoothed;
  smoothing.filter (smoothed);

  double before = 0, after = 0;
  for (std::size_t i = 0; i < smoothed.size (); ++i) {
    before += std::abs ((*noisy)[i].z);
    after += std::abs (smoothed[i].z);
  }
  const auto size = static_cast<double> (smoothed.size ());
  std::cout << "mean distance to the plane: " << before / size << " before, " << after / size << " after\n";
  return after < 0.5 * before ? 0 : 1;
}
