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
  * many in parallel as there are threads. A file is skipped if its output is newer than the file and the report on it
  * has the same options and version. */
class Batch
{
public:
  /** \param[in] options those of the command line that affect the result, each with the text of its value
    * \throw UsageError if both folders are the same
    * \throw FileError if a folder cannot be used, or there is no cloud in \a input_folder */
  Batch (SmoothingJob& job,
         const std::string& input_folder,
         const std::string& output_folder,
         const std::map<std::string, std::string>& options);

  /** Prints on the standard output the outcome of each file, and a summary.
    * \param[in] report path for a list of the reports of all files in the order of their names; for a file that failed,
    *            only its name and exit status; empty: none is written
    * \throw FileError if a file could not be smoothed; the others are smoothed all the same */
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

  /** Smooths files, \a at_once in parallel. */
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
