// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "peer.h"

#include <functional>

namespace pcl_normal_smoothing::evaluation
{

/** Runs peers, single-threaded processes, as many in parallel as there are cores.
  * \param[in] take called from the calling thread with the number of each setting, in the order in which they end */
void
runPeers (const std::vector<PeerSetting>& settings,
          const std::vector<Eigen::Vector3d>& noisy,
          const PeerRun& run,
          const std::function<void (std::size_t, const PeerResult&)>& take);

} // namespace pcl_normal_smoothing::evaluation
