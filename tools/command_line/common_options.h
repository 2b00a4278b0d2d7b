// SPDX-License-Identifier: BSD-3-Clause
//
// Options that have one meaning in all tools.
#pragma once

#include "files/cloud_io.h"
#include "options.h"

#include <pcl_normal_smoothing/core/search/neighbor.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** -seed */
void
addSeedOption (Options& options, const std::string& standard, const std::function<void (std::uint64_t)>& use);

/** -threads \param[out] threads 0 = all cores; must stay valid until the options are parsed */
void
addThreadsOption (Options& options, unsigned& threads);

/** -k -radius -max_radius -threads */
struct SearchOptions
{
  /** k of the tools for the steps of the paper's chain, as that of NormalSmoothing for the chain. */
  static constexpr int standard_k = 15;

  int k = 0;
  double radius = 0;
  double max_radius = 0;
  unsigned threads = 0;

  /** \param[in] k_standard default of k, for the help
    * \param[in] least_k smallest value that is accepted
    * \param[in] more what the help adds about the smallest value */
  void
  addTo (Options& options, const std::string& k_standard, int least_k = 3, const std::string& more = "");

  /** \param[in] k_if_unset used if neither k nor a radius was given
    * \throw UsageError if both were */
  core::NeighborQuery
  query (int k_if_unset = standard_k) const;
};

/** -format */
struct FormatOption
{
  FileFormat format = FileFormat::BINARY;

  void
  addTo (Options& options);
};
} // namespace tools
} // namespace pcl_normal_smoothing
