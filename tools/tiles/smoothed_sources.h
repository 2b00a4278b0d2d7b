// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"

#include <functional>
#include <memory>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Reads the sources of a plan, with the smoothed points in place of the original ones. */
class SmoothedSources
{
public:
  /** \param[in] memory limit in bytes */
  SmoothedSources (const Plan& plan, std::uint64_t memory);
  ~SmoothedSources ();

  static constexpr std::uint32_t no_tile = 0xffffffffu;

  /** The shape of the output for a source. */
  CloudShape
  shapeOf (const CloudShape& source) const;

  /** \param[in] cloud some points of the output
    * \param[in] tiles the tile of each point; no_tile if it is not finite */
  using Use = std::function<void (const pcl::PCLPointCloud2& cloud, const std::vector<std::uint32_t>& tiles)>;

  /** Calls \a use with the points of a source, some at a time. To be called for the sources in their order.
    * \throw FileError if the source is not as `plan` found it, at the latest after its last point */
  void
  read (const Source& source, const Use& use);

private:
  class ResultsInOrder;

  void
  putResults (std::uint64_t first, pcl::PCLPointCloud2& cloud);

  const Plan& plan_;
  std::unique_ptr<ResultsInOrder> results_;
  std::vector<std::uint32_t> tiles_; // of the points at hand
};
} // namespace tools
} // namespace pcl_normal_smoothing
