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

/** What one smoothing has to tell. */
struct SmoothingResult
{
  std::size_t points = 0;
  /** As options that give the same smoothing again. */
  std::string parameters;
  /** What hides the noise of the cloud from small neighbourhoods; empty: nothing. */
  std::string found;
  /** Empty unless asked for. */
  Json report;
};

/** Smooths files, all by the same options. */
class SmoothingJob
{
public:
  /** Adds the options of the method. */
  void
  addOptions (Options& options);

  /** Notes on what is not used of the command line's options. \throw UsageError where they do not fit each other */
  void
  check (const Options& options) const;

  /** The neighbourhoods that the options ask for, in the cloud's unit. */
  core::NeighborQuery
  query () const
  {
    core::NeighborQuery query = search_.query (smoothing_.presetK ());
    query.distinct = smoothing_.options ().robust;
    return query;
  }

  /** Of the output. */
  FileFormat
  format () const
  {
    return format_.format;
  }

  /** Makes a cloud ready to be smoothed: adds the fields of normals where they are to be saved, to a copy.
    * \throw core::Error where it has too few points, or no normals where the options ask for the input's */
  void
  prepare (CloudFile& file) const;

  /** Puts the smoothed cloud in the place of the cloud of \a file.
    * \param[in] graph of query () over the cloud; empty: it is searched \throw core::Error */
  void
  run (CloudFile& file,
       unsigned threads,
       const ProgressCallback& progress,
       const core::NeighborGraph::ConstPtr& graph = nullptr);

  /** What the last run used, as options that give the same smoothing again. */
  std::string
  parameters () const;

  /** Threads that the user asked for, 0 = all cores. */
  unsigned
  threads () const
  {
    return search_.threads;
  }

  /** \param[in] with_report looks at the noise and the displacements, too
    * \throw UsageError, FileError, core::Error; nothing is written then */
  SmoothingResult
  smooth (const std::string& input,
          const std::string& output,
          unsigned threads,
          const ProgressCallback& progress,
          bool with_report);

private:
  /** What a user should know of the cloud that was smoothed. */
  void
  noteTrouble (const CloudFile& input) const;

  NormalSmoothing<pcl::PCLPointCloud2> smoothing_;
  SearchOptions search_;
  FormatOption format_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
