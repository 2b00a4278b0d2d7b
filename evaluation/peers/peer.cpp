// SPDX-License-Identifier: BSD-3-Clause
#include "peer.h"

namespace pcl_normal_smoothing::evaluation
{

std::vector<PeerSetting>
peerSettings ()
{
  return {};
}

PeerResult
runPeer (const PeerSetting&, const std::vector<Eigen::Vector3d>&, const PeerRun&)
{
  return {{}, "not built", 0};
}

std::optional<std::string>
whyAbsent (const std::string&, const PeerRun&)
{
  return "not built";
}

} // namespace pcl_normal_smoothing::evaluation
