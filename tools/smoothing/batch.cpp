// SPDX-License-Identifier: BSD-3-Clause
#include "batch.h"

#include "command_line/process_pool.h"
#include "command_line/tool.h"
#include "files/tool_error.h"
#include "smoothing_report.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <thread>

namespace fs = std::filesystem;

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
/** About a million points: a file of this size or more keeps all threads busy. */
constexpr std::uintmax_t large_file = 16u << 20;

bool
isCloud (const fs::directory_entry& entry)
{
  const std::string extension = extensionOf (entry.path ().string ());
  std::error_code error;
  const fs::file_status status = entry.status (error); // a broken link fails when it is read
  return (extension == ".pcd" || extension == ".ply") && (fs::is_regular_file (status) || !fs::exists (status));
}

/** \return an empty object if there is no readable report */
Json
readReport (const std::string& path)
{
  std::ifstream file (path);
  const Json report = Json::parse (file, nullptr, false);
  return report.is_object () ? report : Json::object ();
}
} // namespace

Batch::Batch (SmoothingJob& job,
              const std::string& input_folder,
              const std::string& output_folder,
              const std::map<std::string, std::string>& options)
: job_ (job), folder_ (input_folder)
{
  for (const auto& [name, text] : options)
    options_[name] = text;
  std::error_code error;
  if (fs::equivalent (input_folder, output_folder, error))
    throw UsageError (output_folder + ": is the input folder, too: name another one for the output");
  try {
    findFiles (output_folder);
  }
  catch (const fs::filesystem_error& trouble) {
    throw FileError (input_folder, "cannot be read (" + trouble.code ().message () + ")",
                     "name a folder of PCD and PLY files");
  }
  if (files_.empty ())
    throw FileError (input_folder, "there is no .pcd or .ply file in it", "name a folder of PCD and PLY files");
  if (fs::create_directories (output_folder, error); error)
    throw FileError (output_folder, "cannot be made (" + error.message () + ")", "name another folder for the output");
}

void
Batch::findFiles (const std::string& output_folder)
{
  for (const fs::directory_entry& entry : fs::directory_iterator (folder_)) {
    if (!isCloud (entry))
      continue;
    const std::string output = (fs::path (output_folder) / entry.path ().filename ()).string ();
    std::error_code error;
    const std::uintmax_t size = entry.file_size (error);
    files_.push_back ({entry.path ().string (), output, output + ".json", error ? 0 : size, 0});
  }
  std::sort (files_.begin (), files_.end (), [] (const File& a, const File& b) { return a.input < b.input; });
}

bool
Batch::isDone (const File& file) const
{
  std::error_code no_input, no_output;
  const auto input_time = fs::last_write_time (file.input, no_input);
  const auto output_time = fs::last_write_time (file.output, no_output);
  if (no_input || no_output || output_time <= input_time)
    return false;
  const Json report = readReport (file.report);
  return report.value ("options", Json ()) == options_ && report.value ("version", Json ()) == version ();
}

void
Batch::smoothOne (const File& file, unsigned threads)
{
  std::error_code none;
  fs::remove (file.report, none); // it describes an earlier output
  Json report = job_.smooth (file.input, file.output, threads, {}, true).report;
  report["options"] = options_;
  saveReport (report, file.report);
}

void
Batch::sayFinished (const File& file)
{
  std::printf ("[%zu/%zu] %s: %s\n", ++finished_, to_do_, file.input.c_str (),
               file.status == 0 ? "smoothed" : ("failed, status " + std::to_string (file.status)).c_str ());
  std::fflush (stdout);
}

void
Batch::smooth (const std::vector<File*>& files, unsigned at_once, unsigned threads)
{
  ProcessPool pool (at_once);
  for (File* file : files)
    pool.start (
        file->input, [=] { smoothOne (*file, threads); },
        [=] (int status) {
          file->status = status;
          sayFinished (*file);
        });
  pool.finish ();
}

void
Batch::run (const std::string& report)
{
  std::vector<File*> large, small;
  for (File& file : files_)
    if (!isDone (file))
      (file.size >= large_file ? large : small).push_back (&file);
  to_do_ = large.size () + small.size ();
  const unsigned threads = job_.threads () > 0 ? job_.threads () : std::max (1u, std::thread::hardware_concurrency ());
  smooth (large, 1, threads);
  smooth (small, threads, 1);
  const auto failed = static_cast<std::size_t> (
      std::count_if (files_.begin (), files_.end (), [] (const File& file) { return file.status != 0; }));
  std::printf ("%s: %zu smoothed, %zu done before, %zu failed\n", counted (files_.size (), "file").c_str (),
               to_do_ - failed, files_.size () - to_do_, failed);
  if (!report.empty ())
    saveReport (reports (), report);
  if (failed > 0)
    throw FileError (folder_, std::to_string (failed) + " of its files could not be smoothed",
                     "see what is said of them above, and run this again: what is done stays");
}

Json
Batch::reports () const
{
  Json reports = Json::array ();
  for (const File& file : files_)
    reports.push_back (file.status == 0 ? readReport (file.report)
                                        : Json {{"input", file.input}, {"exit_status", file.status}});
  return reports;
}
} // namespace tools
} // namespace pcl_normal_smoothing
