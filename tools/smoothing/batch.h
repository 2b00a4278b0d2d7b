// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "smoothing_job.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** Smooths all clouds of a folder into another one, under the same names, with a report beside each: "scan.pcd.json".
  *
  * Files of 16 MiB and more come first, one by one, with all threads; then the smaller ones, with one thread each, as
  * many side by side as there are threads. A file is not smoothed again where its output is newer than itself and its
  * report tells of the same options and version. */
class Batch
{
public:
  /** \param[in] options those of the command line that change the result, each with its text
    * \throw UsageError where both folders are the same
    * \throw FileError where a folder cannot be used, or there is no cloud in \a input_folder */
  Batch (SmoothingJob& job,
         const std::string& input_folder,
         const std::string& output_folder,
         const std::map<std::string, std::string>& options);

  /** Shows on the standard output how each file ended, and a summary.
    * \param[in] report to be written, a list of all files' reports by their names; of a file that failed: its name and
    *            exit status; empty: none
    * \throw FileError where a file could not be smoothed; the others are */
  void
  run (const std::string& report);

private:
  struct File
  {
    std::string input, output, report;
    std::uintmax_t size;
    int status;
  };

  void
  findFiles (const std::string& output_folder);

  bool
  isDone (const File& file) const;

  /** Smooths files, \a at_once side by side. */
  void
  smooth (const std::vector<File*>& files, unsigned at_once, unsigned threads);

  void
  smoothOne (const File& file, unsigned threads);

  void
  sayFinished (const File& file);

  Json
  reports () const;

  SmoothingJob& job_;
  std::string folder_;
  Json options_ = Json::object ();
  std::vector<File> files_;
  std::size_t to_do_ = 0;
  std::size_t finished_ = 0;
};
} // namespace tools
} // namespace pcl_normal_smoothing
