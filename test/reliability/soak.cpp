// SPDX-License-Identifier: BSD-3-Clause
//
// usage: soak [clouds]      default 1000
// Smooths many clouds in one process, valid and invalid ones, and watches its memory, which must not grow by more than
// 3 % after the first tenth. Exit status 1 if it does, or if a cloud gives a wrong outcome.
#include "shapes.h"

#include <pcl_normal_smoothing/normal_smoothing.h>

#include <pcl/console/print.h>

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <vector>

namespace
{
using namespace pcl_normal_smoothing;
using Cloud = pcl::PointCloud<pcl::PointNormal>;

constexpr int cycle = 60; // number of clouds in which all sizes and presets occur

/** After releasing unused heap memory: how much the heap keeps depends on the order in which threads start. */
double
residentMegabytes ()
{
  malloc_trim (0);
  std::size_t pages = 0, resident = 0;
  std::ifstream ("/proc/self/statm") >> pages >> resident;
  return static_cast<double> (resident) * static_cast<double> (sysconf (_SC_PAGESIZE)) / 1e6;
}

/** Sizes repeat every 20 clouds; of these, one has only two points, and one run is cancelled. */
Cloud::Ptr
makeCloud (int number)
{
  const int size = number % 20 == 13 ? 2 : 1000 + 700 * (number % 20);
  const auto shape = test_support::torus (size, 1, 0.4);
  auto cloud = std::make_shared<Cloud> ();
  for (const auto& position : test_support::withNoise (shape.points, 0.01, static_cast<std::uint64_t> (number))) {
    cloud->emplace_back ();
    cloud->back ().getVector3fMap () = position;
  }
  return cloud;
}

/** \return whether it ended as expected */
bool
smooth (NormalSmoothing<pcl::PointNormal>& smoothing, int number)
{
  const Cloud::Ptr cloud = makeCloud (number);
  constexpr SmoothingPreset presets[] = {SmoothingPreset::DEFAULT, SmoothingPreset::FAST, SmoothingPreset::PAPER};
  smoothing.setPreset (presets[number % 3]);
  const bool cancel = number % 20 == 17;
  smoothing.setProgressCallback ([cancel] (double done) { return !cancel || done < 0.5; });
  smoothing.setInputCloud (cloud);
  Cloud output;
  smoothing.filter (output);
  if (cloud->size () < 3)
    return output.empty () && !smoothing.getErrorMessage ().empty ();
  return output.size () == cloud->size () && smoothing.wasCancelled () == cancel;
}
} // namespace

int
main (int argc, char** argv)
{
  const int count = argc > 1 ? std::atoi (argv[1]) : 1000;
  if (count < cycle) {
    std::printf ("usage: soak [clouds]: at least %d, one of each kind\n", cycle);
    return 1;
  }
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); // errors are expected
  NormalSmoothing<pcl::PointNormal> smoothing;
  std::vector<double> memory;
  for (int number = 0; number < count; ++number) {
    if (!smooth (smoothing, number)) {
      std::printf ("cloud %d: %s\n", number, smoothing.getErrorMessage ().c_str ());
      return 1;
    }
    memory.push_back (residentMegabytes ());
  }
  const auto begin = memory.begin () + std::min (count / 10, count - cycle);
  const double first = *std::max_element (begin, begin + cycle);
  const double last = *std::max_element (memory.end () - cycle, memory.end ());
  std::printf ("%d clouds: at most %.1f MB in %d of them after the first tenth, %.1f MB in the last (%+.1f %%)\n",
               count, first, cycle, last, 100 * (last / first - 1));
  return last > 1.03 * first ? 1 : 0;
}
