// SPDX-License-Identifier: BSD-3-Clause
//
// Whole programs on one file, reading and writing included: the peers, unmodified, and the tool, with their accuracy:
// ./programs [points]
#include "clouds.h"
#include "timing.h"

#include <peer.h>
#include <process.h>

#include <pcl/io/pcd_io.h>

#include <cstdio>
#include <string>

namespace
{
using namespace pcl_normal_smoothing;
using namespace pcl_normal_smoothing::benchmarks;

constexpr double time_limit = 600;
constexpr int repetitions = 3;

struct Program
{
  std::string name;
  double seconds = 0;
  double distance = 0;
  std::string failure;
};

Program
runTool (const Cloud& cloud, const std::string& preset)
{
  const evaluation::WorkFolder folder (".");
  const std::string input = folder.file ("in.pcd"), output = folder.file ("out.pcd");
  pcl::io::savePCDFileBinary (input, cloud);
  Program program {"pcl_normal_smoothing -preset " + preset, 0, 0, {}};
  std::vector<double> seconds;
  for (int repetition = 0; repetition < repetitions && program.failure.empty (); ++repetition) {
    const auto outcome = evaluation::runProcess ({TOOL, input, output, "-preset", preset}, folder, time_limit);
    seconds.push_back (outcome.seconds);
    program.failure = outcome.failure;
  }
  program.seconds = median (seconds);
  Cloud smoothed;
  if (program.failure.empty () && pcl::io::loadPCDFile (output, smoothed) != 0)
    program.failure = "its output cannot be read";
  if (program.failure.empty ())
    program.distance = meanDistance (smoothed);
  return program;
}

Program
runPeer (const Cloud& cloud, const evaluation::PeerSetting& setting)
{
  std::vector<Eigen::Vector3d> points;
  for (const auto& point : cloud)
    points.push_back (point.getVector3fMap ().cast<double> ());
  evaluation::PeerRun run;
  run.time_limit = time_limit;
  const evaluation::PeerResult result = evaluation::runPeer (setting, points, run);
  Cloud smoothed;
  for (const auto& point : result.points)
    smoothed.emplace_back (static_cast<float> (point.x ()), static_cast<float> (point.y ()),
                           static_cast<float> (point.z ()));
  return {setting.peer + ", " + setting.parameters, result.seconds, meanDistance (smoothed), result.failure};
}
} // namespace

int
main (int argc, char** argv)
{
  const Cloud::Ptr cloud = makeTorus (argc > 1 ? std::stoul (argv[1]) : 25000, Order::RANDOM);
  std::vector<Program> programs {runTool (*cloud, "default"), runTool (*cloud, "fast")};
  for (const auto& setting : evaluation::peerSettings ())
    if (setting.is_default)
      programs.push_back (runPeer (*cloud, setting));

  std::printf ("%zu points, whole programs\n\n| program | seconds | default preset's time / its time | p2s ratio |\n"
               "|---|---|---|---|\n",
               cloud->size ());
  const double noisy = meanDistance (*cloud);
  for (const Program& program : programs)
    if (program.failure.empty ())
      std::printf ("| %s | %.2f | %.3f | %.3f |\n", program.name.c_str (), program.seconds,
                   programs[0].seconds / program.seconds, program.distance / noisy);
    else
      std::printf ("| %s | | | %s |\n", program.name.c_str (), program.failure.c_str ());
}
