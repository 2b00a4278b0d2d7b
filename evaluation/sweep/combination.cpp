// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/combination.h"

#include <pcl_normal_smoothing/smoothing_settings.h>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
struct Settings : SmoothingSettings
{};
} // namespace

std::string
Combination::name () const
{
  const char* const sources[] = {"P", "WP", "H"};
  const char* const weights[] = {"T", "G", "M"};
  return std::string (sources[static_cast<int> (source)]) + weights[static_cast<int> (weight)] + "U" +
         std::to_string (k);
}

std::string
Combination::parameters () const
{
  const char* const sources[] = {"pca", "wpca", "hough"};
  const char* const weights[] = {"threshold", "gaussian", "mixed"};
  return std::string ("-preset paper -normals ") + sources[static_cast<int> (source)] + " -weights " +
         weights[static_cast<int> (weight)] + " -k " + std::to_string (k) + " -normal_iterations " +
         std::to_string (normal_iterations) + " -point_iterations " + std::to_string (point_iterations);
}

core::SmoothingOptions
Combination::options () const
{
  Settings settings;
  settings.setPreset (SmoothingPreset::PAPER);
  settings.setNormalSource (source);
  settings.setNormalWeight (weight);
  settings.setNormalIterations (normal_iterations);
  settings.setPointIterations (point_iterations);
  return settings.options ();
}

std::vector<Combination>
allCombinations ()
{
  std::vector<Combination> all;
  for (const NormalSource source : {NormalSource::PCA, NormalSource::WPCA, NormalSource::HOUGH})
    for (const NormalWeight weight : {NormalWeight::THRESHOLD, NormalWeight::GAUSSIAN, NormalWeight::MIXED})
      for (const int k : {7, 15, 21})
        for (const int normal_iterations : {2, 4, 8, 16, 32})
          for (const int point_iterations : {5, 10, 20, 40})
            all.push_back ({source, weight, k, normal_iterations, point_iterations});
  return all;
}

} // namespace pcl_normal_smoothing::evaluation
