// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tool_runner.h"

#include <Eigen/Core>

/** Clouds, and what tiles make of them. */
class Tiles : public ToolTest
{
protected:
  using Cloud = std::vector<Eigen::Vector3d>;

  /** As PCD or PLY, of floats. */
  void
  saveCloud (const Cloud& cloud, const std::string& name) const;

  /** Plans, runs and merges a file, and compares with what pcl_normal_smoothing makes of it, to the byte.
    * \param[in] size options of plan that say how large tiles are
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

  /** A noisy wave, in an order that does not follow space. */
  static Cloud
  wavyCloud (std::size_t points);

  /** Balls of different sizes and densities, far apart; points that are there several times; lonely points. */
  static Cloud
  clusters ();

  /** Two noisy sheets that are less than two spacings apart. */
  static Cloud
  closeSheets ();

  /** A wave that is the noisier the farther it is, in an order that does not follow space. */
  static Cloud
  unevenlyNoisyWave ();
};
