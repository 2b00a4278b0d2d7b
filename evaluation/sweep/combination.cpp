// SPDX-License-Identifier: BSD-3-Clause
#include "sweep/combination.h"

#include <pcl_normal_smoothing/smoothing_settings.h>

#include <map>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
struct Settings : SmoothingSettings
{};

/** The paper's name for an option, and the tools'. */
struct Names
{
  std::string paper, tool;
};

const Names&
namesOf (NormalSource source)
{
  static const std::map<NormalSource, Names> names {{NormalSource::PCA, {"P", "pca"}},
                                                    {NormalSource::WPCA, {"WP", "wpca"}},
                                                    {NormalSource::HOUGH, {"H", "hough"}}};
  return names.at (source);
}

const Names&
namesOf (NormalWeight weight)
{
  static const std::map<NormalWeight, Names> names {{NormalWeight::THRESHOLD, {"T", "threshold"}},
                                                    {NormalWeight::GAUSSIAN, {"G", "gaussian"}},
                                                    {NormalWeight::MIXED, {"M", "mixed"}}};
  return names.at (weight);
}
} // namespace

std::string
Combination::name () const
{
  return namesOf (source).paper + namesOf (weight).paper + "U" + std::to_string (k);
}

std::string
Combination::parameters () const
{
  return "-preset paper -normals " + namesOf (source).tool + " -weights " + namesOf (weight).tool + " -k " +
         std::to_string (k) + " -normal_iterations " + std::to_string (normal_iterations) + " -point_iterations " +
         std::to_string (point_iterations);
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
