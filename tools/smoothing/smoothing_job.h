// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line/method_options.h"

#include <pcl_normal_smoothing/normal_smoothing.h>

#include <nlohmann/json.hpp>

namespace pcl_normal_smoothing
{
namespace tools
{
using Json = nlohmann::ordered_json;

/** What is known after a smoothing. */
struct SmoothingResult
{
  std::size_t points = 0;
  /** The parameters used, as options that reproduce it. */
  std::string parameters;
  /** What hides the noise of the cloud from small neighbourhoods; empty: nothing. */
  std::string found;
  /** Empty unless asked for. */
  Json report;
};

/** Smooths files, all with the same options. */
class SmoothingJob
{
public:
  /** Adds the options of the method. */
  void
  addOptions (Options& options);

  /** Prints notes on options without effect, or with a surprising one. \throw UsageError for contradictory options */
  void
  check (const Options& options) const;

  /** The neighbourhoods to search for by the options, in the cloud's unit. */
  core::NeighborQuery
  query () const
  {
    core::NeighborQuery query = search_.query (smoothing_.presetK ());
    query.distinct = smoothing_.options ().in_rounds;
    return query;
  }

  /** The format of the output. */
  FileFormat
  format () const
  {
    return format_.format;
  }

  /** Prepares a cloud for smoothing: if normals are to be saved, replaces it by a copy that has fields for them.
    * \throw core::Error if it has too few points, or lacks normals although the options ask for the input's */
  void
  prepare (CloudFile& file) const;

  /** Replaces the cloud of \a file by the smoothed one.
    * \param[in] graph the neighbourhoods of query () in the cloud; null: they are searched
    * \throw core::Error; \a file stays as it was */
  void
  run (CloudFile& file,
       unsigned threads,
       const ProgressCallback& progress,
       const core::NeighborGraph::ConstPtr& graph = nullptr);

  /** The parameters that the last run used, as options that reproduce it. */
  std::string
  parameters () const;

  /** Threads that the user asked for, 0 = all cores. */
  unsigned
  threads () const
  {
    return search_.threads;
  }

  /** \param[in] with_report fills in the report, noise and displacements included
    * \throw UsageError, FileError, core::Error; nothing is written then */
  SmoothingResult
  smooth (const std::string& input,
          const std::string& output,
          unsigned threads,
          const ProgressCallback& progress,
          bool with_report);

private:
  /** Prints a note on a problem of the cloud that was smoothed, if there is one. */
  void
  noteTrouble (const CloudFile& input) const;

  NormalSmoothing<pcl::PCLPointCloud2> smoothing_;
  SearchOptions search_;
  FormatOption format_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
