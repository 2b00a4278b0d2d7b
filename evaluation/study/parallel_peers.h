// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "peer.h"

#include <functional>

namespace pcl_normal_smoothing::evaluation
{

/** Runs peers, which have one thread each, as many at once as there are cores.
  * \param[in] take called with the number of the setting in the order in which they end, from the calling thread */
void
runPeers (const std::vector<PeerSetting>& settings,
          const std::vector<Eigen::Vector3d>& noisy,
          const PeerRun& run,
          const std::function<void (std::size_t, const PeerResult&)>& take);

} // namespace pcl_normal_smoothing::evaluation
