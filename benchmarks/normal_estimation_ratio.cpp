// SPDX-License-Identifier: BSD-3-Clause
//
// Times the whole smoothing against pcl::NormalEstimationOMP alone, on one cloud in random order, in one run, and prints
// the ratio: ./normal_estimation_ratio [points, default 1000000] [repetitions, default 3]
#include <pcl_normal_smoothing/normal_smoothing.h>

#include <pcl/features/normal_3d_omp.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <random>

namespace
{
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** A noisy torus, its points in random order. */
Cloud::Ptr
makeTorus (std::size_t size)
{
  std::mt19937_64 random (1);
  std::uniform_real_distribution<double> angle (0, 2 * M_PI);
  const double spacing = std::sqrt (4 * M_PI * M_PI * 0.4 / static_cast<double> (size));
  std::normal_distribution<double> noise (0, 0.2 * spacing);
  auto cloud = pcl::make_shared<Cloud> ();
  for (std::size_t i = 0; i < size; ++i) {
    const double u = angle (random), v = angle (random), r = 0.4 + noise (random);
    cloud->emplace_back (static_cast<float> ((1 + r * std::cos (v)) * std::cos (u)),
                         static_cast<float> ((1 + r * std::cos (v)) * std::sin (u)),
                         static_cast<float> (r * std::sin (v)));
  }
  return cloud;
}

/** Mean distance to the torus. */
double
meanDistance (const Cloud& cloud)
{
  double sum = 0;
  for (const auto& p : cloud)
    sum += std::abs (std::hypot (std::hypot (p.x, p.y) - 1.0, static_cast<double> (p.z)) - 0.4);
  return sum / static_cast<double> (cloud.size ());
}

template <typename Run>
double
seconds (const Run& run)
{
  const auto start = std::chrono::steady_clock::now ();
  run ();
  return std::chrono::duration<double> (std::chrono::steady_clock::now () - start).count ();
}

double
median (std::vector<double> values)
{
  std::sort (values.begin (), values.end ());
  return values[values.size () / 2];
}

double
peakBytes ()
{
  rusage usage {};
  getrusage (RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double> (usage.ru_maxrss);
}
} // namespace

int
main (int argc, char** argv)
{
  using namespace pcl_normal_smoothing;
  const std::size_t size = argc > 1 ? std::stoul (argv[1]) : 1000000;
  const int repetitions = argc > 2 ? std::stoi (argv[2]) : 3;
  const Cloud::Ptr cloud = makeTorus (size);
  const double noisy = meanDistance (*cloud);
  const double before = peakBytes ();

  std::vector<double> theirs, ours[2];
  const SmoothingPreset presets[] = {SmoothingPreset::DEFAULT, SmoothingPreset::FAST};
  double ratio[2] {}, memory = 0;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (int preset = 0; preset < 2; ++preset) {
      NormalSmoothing<pcl::PointXYZ> smoothing;
      smoothing.setPreset (presets[preset]);
      smoothing.setInputCloud (cloud);
      Cloud smoothed;
      ours[preset].push_back (seconds ([&] { smoothing.filter (smoothed); }));
      ratio[preset] = meanDistance (smoothed) / noisy;
    }
    if (repetition == 0)
      memory = (peakBytes () - before) / static_cast<double> (size);
    theirs.push_back (seconds ([&] {
      pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation;
      estimation.setKSearch (16);
      estimation.setInputCloud (cloud);
      pcl::PointCloud<pcl::Normal> normals;
      estimation.compute (normals);
    }));
  }
  std::cout << size << " points in random order, all cores, median of " << repetitions << "\n"
            << "pcl::NormalEstimationOMP, k = 16: " << median (theirs) << " s\n";
  for (int preset = 0; preset < 2; ++preset)
    std::cout << "NormalSmoothing, preset " << (preset == 0 ? "default" : "fast") << ": " << median (ours[preset])
              << " s, time ratio " << median (ours[preset]) / median (theirs) << ", p2s ratio " << ratio[preset] << "\n";
  std::cout << "peak memory above the input: " << memory << " bytes a point\n";
}
