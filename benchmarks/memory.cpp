// SPDX-License-Identifier: BSD-3-Clause
//
// Peak memory of one smoothing besides its input and output, in bytes per point:
// ./memory default|fast|paper [k] [points]
#include "clouds.h"

#include <pcl_normal_smoothing/normal_smoothing.h>

#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>

int
main (int argc, char** argv)
{
  using namespace pcl_normal_smoothing;
  const std::map<std::string, SmoothingPreset> presets {{"default", SmoothingPreset::DEFAULT},
                                                        {"fast", SmoothingPreset::FAST},
                                                        {"paper", SmoothingPreset::PAPER}};
  const std::string name = argc > 1 ? argv[1] : "default";
  if (presets.count (name) == 0) {
    std::fputs ("usage: memory default|fast|paper [k] [points]\n", stderr);
    return EXIT_FAILURE;
  }
  NormalSmoothing<pcl::PointXYZ> smoothing;
  smoothing.setPreset (presets.at (name));
  if (argc > 2)
    smoothing.setKSearch (std::stoi (argv[2]));
  const auto cloud = benchmarks::makeTorus (argc > 3 ? std::stoul (argv[3]) : 1000000, benchmarks::Order::RANDOM);
  benchmarks::Cloud smoothed = *cloud; // so that the output's memory is already allocated and touched
  smoothing.setInputCloud (cloud);

  const auto peak = [] {
    rusage usage {};
    getrusage (RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double> (usage.ru_maxrss);
  };
  const double before = peak ();
  smoothing.filter (smoothed);
  std::printf ("| %s | %d | %.0f |\n", name.c_str (), smoothing.getKSearch (),
               (peak () - before) / static_cast<double> (cloud->size ()));
}
