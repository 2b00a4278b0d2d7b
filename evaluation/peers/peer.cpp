// SPDX-License-Identifier: BSD-3-Clause
#include "peer.h"

#include "meshlab.h"
#include "point_file.h"
#include "process.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Points = std::vector<Eigen::Vector3d>;

const std::string advice = "run evaluation/install_peers.sh";
const char* const input_name = "noisy.points";
const char* const output_name = "smooth.points";

bool
isOfMeshLab (const std::string& peer)
{
  return peer == "APSS" || peer == "RIMLS";
}

std::string
workerOf (const PeerRun& run)
{
  return run.worker.empty () ? PEER_PROGRAM : run.worker;
}

/** Normalises the cloud for the peers: centred at the origin, with a diagonal of 1. MeshLab works in single precision,
  * and CGAL's WLOP has thresholds that do not scale. */
struct Frame
{
  Eigen::Vector3d origin;
  double scale;

  /** \throw std::runtime_error if a point is not finite, or all are equal */
  explicit Frame (const Points& points)
  {
    Eigen::AlignedBox3d box;
    for (std::size_t i = 0; i < points.size (); ++i) {
      if (!points[i].allFinite ())
        throw std::runtime_error ("input point " + std::to_string (i) + " is not finite");
      box.extend (points[i]);
    }
    if (points.empty () || !(box.diagonal ().norm () > 0))
      throw std::runtime_error ("the input has no two different points");
    origin = box.center ();
    scale = box.diagonal ().norm ();
  }

  Points
  inside (Points points) const
  {
    for (auto& point : points)
      point = (point - origin) / scale;
    return points;
  }

  Points
  outside (Points points) const
  {
    for (auto& point : points)
      point = origin + scale * point;
    return points;
  }
};

std::vector<std::string>
workerCommand (const WorkFolder& folder, const PeerSetting& setting, const std::string& worker)
{
  std::vector<std::string> command {worker, setting.peer, folder.file (input_name), folder.file (output_name)};
  for (const auto& [name, value] : setting.values) {
    std::ostringstream text;
    text.precision (17);
    text << name << '=' << value;
    command.push_back (text.str ());
  }
  return command;
}

/** A peer's output. \throw std::runtime_error if it is not one finite point per \a input point */
Points
checked (Points points, const Points& input)
{
  if (points.size () != input.size ())
    throw std::runtime_error ("gave " + std::to_string (points.size ()) + " points for " +
                              std::to_string (input.size ()));
  for (std::size_t i = 0; i < points.size (); ++i)
    if (!points[i].allFinite ())
      throw std::runtime_error ("gave a point that is not finite, number " + std::to_string (i));
  return points;
}

/** Makes a relative file name absolute, as the program runs in another folder. */
std::string
withFolder (const std::string& program)
{
  return program.find ('/') == std::string::npos ? program : std::filesystem::absolute (program).string ();
}

/** The result in the peers' frame. \param[in, out] result failure and seconds are set as soon as they are known */
Points
runIn (const WorkFolder& folder,
       const PeerSetting& setting,
       const Points& points,
       const PeerRun& run,
       PeerResult& result)
{
  const bool meshlab = isOfMeshLab (setting.peer);
  if (meshlab)
    writeMeshLabInput (folder, setting, points);
  else
    writePoints (folder.file (input_name), points);
  const auto command = meshlab ? meshLabCommand (folder, withFolder (run.meshlabserver))
                               : workerCommand (folder, setting, withFolder (workerOf (run)));
  const ProcessOutcome outcome = runProcess (command, folder, run.time_limit);
  result.seconds = outcome.seconds;
  result.failure = outcome.failure;
  if (!result.failure.empty ())
    return {};
  return checked (meshlab ? readMeshLabOutput (folder) : readPoints (folder.file (output_name)), points);
}
} // namespace

PeerResult
runPeer (const PeerSetting& setting, const Points& noisy, const PeerRun& run)
{
  PeerResult result;
  try {
    if (const auto why = whyAbsent (setting.peer, run))
      throw std::runtime_error (*why);
    const Frame frame (noisy);
    const WorkFolder folder (run.work_folder);
    result.points = frame.outside (runIn (folder, setting, frame.inside (noisy), run, result));
  }
  catch (const std::exception& error) {
    result.failure = error.what ();
  }
  return result;
}

std::optional<std::string>
whyAbsent (const std::string& peer, const PeerRun& run)
{
  if (isOfMeshLab (peer)) {
    for (const std::string& program : {run.meshlabserver, std::string ("xvfb-run"), std::string ("xauth")})
      if (!isInstalled (program))
        return program + " is not installed: " + advice;
    return std::nullopt;
  }
  if (!isInstalled (workerOf (run)))
    return workerOf (run) + " is not there: build the target pcl_smoothing_peer";
  return std::nullopt;
}

} // namespace pcl_normal_smoothing::evaluation
