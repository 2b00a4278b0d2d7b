// SPDX-License-Identifier: BSD-3-Clause
//
// Time that the viewer takes from a key press that changes a parameter to the new picture: ./viewer [points]
#include "clouds.h"
#include "timing.h"

#include <smoothing/smoothing_job.h>
#include <viewer/display.h>
#include <viewer/viewer.h>

#include <pcl/io/pcd_io.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <unistd.h>

using namespace pcl_normal_smoothing;

namespace
{
/** A file that is removed when the program ends. */
class CloudOnDisk
{
public:
  explicit CloudOnDisk (const benchmarks::Cloud& cloud)
  : path_ (std::filesystem::temp_directory_path () / ("viewer_benchmark_" + std::to_string (getpid ()) + ".pcd"))
  {
    pcl::io::savePCDFileBinary (path_, cloud);
  }

  ~CloudOnDisk ()
  {
    std::filesystem::remove (path_);
  }

  CloudOnDisk (const CloudOnDisk&) = delete;
  CloudOnDisk&
  operator= (const CloudOnDisk&) = delete;

  const std::string&
  path () const
  {
    return path_;
  }

private:
  std::string path_;
};
} // namespace

int
main (int argc, char** argv)
{
  const std::size_t points = argc > 1 ? std::stoul (argv[1]) : 100000;
  const CloudOnDisk cloud (*benchmarks::makeTorus (points, benchmarks::Order::RANDOM));
  tools::WindowSettings settings;
  settings.off_screen = true;
  const tools::Display display (true);
  tools::ViewerSession session (cloud.path (), "");
  tools::ViewerWindow window (settings, session.noisy (), session.triangles (), session.viewpoint (),
                              session.spacing ());
  tools::Options options;
  tools::SmoothingJob job;
  job.addOptions (options);
  tools::Viewer viewer (session, tools::ViewerParameters ({}, options), window, tools::Colouring::DISPLACEMENT, {});
  viewer.press ("h"); // the first picture also prepares the window

  std::printf ("%zu points\n\n| key | what it does | smoothing, s | key to picture, s |\n|---|---|---|---|\n", points);
  for (const auto& [key, what] :
       {std::make_pair ("s", "smaller noise sigma"), std::make_pair ("K", "more neighbours: searches them"),
        std::make_pair ("2", "preset fast"), std::make_pair ("3", "preset paper"),
        std::make_pair ("1", "preset default"), std::make_pair ("c", "colours: smooths nothing")}) {
    const double smoothed_before = session.seconds ();
    const double taken = benchmarks::seconds ([&, pressed = key] { viewer.press (pressed); });
    const bool smooths = session.seconds () != smoothed_before;
    std::printf ("| %s | %s | %.2f | %.2f |\n", key, what, smooths ? session.seconds () : 0, taken);
  }
}
