// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "plan.h"

#include <functional>
#include <memory>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Goes through the sources of a plan, with the smoothed points in place of theirs. */
class SmoothedSources
{
public:
  /** \param[in] memory bytes that it may take */
  SmoothedSources (const Plan& plan, std::uint64_t memory);
  ~SmoothedSources ();

  static constexpr std::uint32_t no_tile = 0xffffffffu;

  /** The fields of the output. */
  CloudShape
  shapeOf (const CloudShape& source) const;

  /** \param[in] cloud some points of the output
    * \param[in] tiles that they belong to; no_tile where one is not finite */
  using Use = std::function<void (const pcl::PCLPointCloud2& cloud, const std::vector<std::uint32_t>& tiles)>;

  /** Hands over the points of a source; the sources come one after the other.
    * \throw FileError where the source is not what `plan` has seen, at the latest behind its last point */
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
