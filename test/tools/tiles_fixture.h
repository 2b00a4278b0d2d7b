// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_runner.h"

#include <Eigen/Core>

/** Clouds, and their smoothing by tiles. */
class Tiles : public ToolTest
{
protected:
  using Cloud = std::vector<Eigen::Vector3d>;

  /** Saves as PCD or PLY, in float. */
  void
  saveCloud (const Cloud& cloud, const std::string& name) const;

  /** Plans, runs and merges a file, and expects the same bytes as from pcl_normal_smoothing.
    * \param[in] size options of plan that determine the size of tiles
    * \param[in] options of the method
    * \param[in] extension, format of the output */
  void
  expectSame (const std::string& file,
              const std::string& size,
              const std::string& options,
              const std::string& extension = ".pcd",
              const std::string& format = "") const;

  std::set<std::string>
  filesIn (const std::string& folder) const;

  /** A noisy wave, in an order that is not spatial. */
  static Cloud
  wavyCloud (std::size_t points);

  /** Balls of different sizes and densities, far apart, with duplicate points and isolated ones. */
  static Cloud
  clusters ();

  /** Two noisy sheets that are less than two spacings apart. */
  static Cloud
  closeSheets ();

  /** A wave whose noise grows with distance, in an order that is not spatial. */
  static Cloud
  unevenlyNoisyWave ();
};
