// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** One setting of one peer: another method, in a published implementation (LOP: our own). */
struct PeerSetting
{
  /** "APSS", "RIMLS", "LOP", "WLOP", "CGAL jet", "CGAL bilateral" or "PCL MLS". */
  std::string peer;
  /** Readable description for tables: "filter scale 2, spherical parameter 1". */
  std::string parameters;
  /** Whether this is the peer's own default. Exactly one setting of each peer is. */
  bool is_default = false;
  /** Values by name, read by the adapter of this peer. Lengths are in spacings of the noisy cloud: here, the mean over
    * its points of the mean distance to the 6 nearest others. */
  std::map<std::string, double> values;
};

/** Where and how long a peer may run. */
struct PeerRun
{
  /** Must exist and be writable; runPeer leaves nothing behind in it. Simultaneous runs may share it. */
  std::string work_folder = ".";
  /** Wall time in seconds after which the peer and all processes that it started are killed. */
  double time_limit = 120;
  /** Looked up in PATH unless it contains a slash. */
  std::string meshlabserver = "meshlabserver";
  /** The program that contains all peers but MeshLab's; empty: that of this build. */
  std::string worker;
};

/** The outcome of a peer's run. */
struct PeerResult
{
  /** Point i is the new position of input point i. Empty if the peer failed. */
  std::vector<Eigen::Vector3d> points;
  /** Empty on success, otherwise the reason: "timed out after 120 s". */
  std::string failure;
  /** The peer's wall time, including its start and reading and writing its files. */
  double seconds = 0;
};

/** Every setting of every peer, grouped by peer, in a fixed order. */
std::vector<PeerSetting>
peerSettings ();

/** Smooths \a noisy in a separate process, which sees the cloud at the origin with a diagonal of 1. A point that the
  * peer drops, as PCL's MLS does if it has no neighbours, keeps its position. Several threads may run peers at once.
  *
  * Never throws for what the peer does: a crash, a non-zero status, a time-out, and output with another number of
  * points or with non-finite coordinates are all reported as failures. So is input with a non-finite point, or without
  * two different points. */
PeerResult
runPeer (const PeerSetting& setting, const std::vector<Eigen::Vector3d>& noisy, const PeerRun& run = {});

/** The reason why \a peer cannot run on this machine, and the remedy, such as "meshlabserver is not installed: run
  * evaluation/install_peers.sh"; nothing if it can. */
std::optional<std::string>
whyAbsent (const std::string& peer, const PeerRun& run = {});

} // namespace pcl_normal_smoothing::evaluation
