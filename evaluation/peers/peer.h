// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** One setting of one peer: another method, run as others wrote it. */
struct PeerSetting
{
  /** "APSS", "RIMLS", "LOP", "WLOP", "CGAL jet", "CGAL bilateral" or "PCL MLS". */
  std::string peer;
  /** For people and tables: "filter scale 2, spherical parameter 1". */
  std::string parameters;
  /** The peer's own default. Exactly one setting of each peer is. */
  bool is_default = false;
  /** By name, what the adapter of this peer reads. Lengths are in spacings of the noisy cloud: the mean over its points
    * of the mean distance to the 6 nearest others. */
  std::map<std::string, double> values;
};

/** Where and how long a peer may run. */
struct PeerRun
{
  /** Exists and can be written; runPeer leaves nothing behind in it. Runs at the same time may share it. */
  std::string work_folder = ".";
  /** Seconds of wall time, after which the peer and all that it started are killed. */
  double time_limit = 120;
  /** Looked up in PATH where it has no slash. */
  std::string meshlabserver = "meshlabserver";
  /** The program that holds all peers but MeshLab's; empty: the one of this build. */
  std::string worker;
};

/** What came of it. */
struct PeerResult
{
  /** Point i is what became of input point i. Empty where the peer failed. */
  std::vector<Eigen::Vector3d> points;
  /** Empty where it worked, else the reason: "timed out after 120 s". */
  std::string failure;
  /** The peer's wall time, with starting it, and reading and writing its files. */
  double seconds = 0;
};

/** Every setting of every peer, those of one peer together, in an order that does not change. */
std::vector<PeerSetting>
peerSettings ();

/** Smooths \a noisy as a process of its own, which sees the cloud at the origin with a diagonal of 1. A point that the
  * peer drops, as PCL's MLS does without neighbors, stays as it was. Several threads may run peers at once.
  *
  * Never throws for what the peer does: a crash, a non-zero status, a time-out and output of another size or with
  * numbers that are not finite are all failures; so is input without two different points, or with one that is not
  * finite. */
PeerResult
runPeer (const PeerSetting& setting, const std::vector<Eigen::Vector3d>& noisy, const PeerRun& run = {});

/** Why \a peer cannot run on this machine, and what to do, such as "meshlabserver is not installed: run
  * evaluation/install_peers.sh"; nothing where it can. */
std::optional<std::string>
whyAbsent (const std::string& peer, const PeerRun& run = {});

} // namespace pcl_normal_smoothing::evaluation
