// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/tool.h"
#include "files/tool_error.h"
#include "smoothing/batch.h"
#include "smoothing/smoothing_report.h"

#include <cstdio>
#include <filesystem>

using namespace pcl_normal_smoothing;

namespace
{
class NormalSmoothingTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe (std::string (
                          "Smooths the points of a noisy surface without rounding its edges; keeps every other "
                          "field.\n") +
                          tools::presets_and_chain,
                      {"input.pcd|ply", "output.pcd|ply"});
    job_.addOptions (options);
    const auto into = [] (std::string& text) { return [&text] (const std::string& given) { text = given; }; };
    options.add ("-report", "R.json", "write a report: parameters, noise, displacements, seconds", "none",
                 into (report_));
    options.add ("-input_dir", "A",
                 "smooth every PCD and PLY file of a folder, but not of those in it, that is not done yet; one that "
                 "fails is named, the others go on",
                 "none", into (input_folder_));
    options.add ("-output_dir", "B", "to these names in another folder, each with a report beside it", "none",
                 into (output_folder_));
    options.replaceFilesBy ({"-input_dir", "-output_dir"});
  }

  void
  work (const tools::Options& options) override
  {
    job_.check (options);
    if (!report_.empty ())
      tools::checkReport (report_);
    if (options.given ("-input_dir"))
      smoothFolder (options);
    else
      smoothFile (options.file (0), options.file (1));
  }

  void
  smoothFile (const std::string& input, const std::string& output)
  {
    std::error_code error;
    if (std::filesystem::is_directory (input, error))
      throw tools::FileError (input, "is a folder", "give it with -input_dir, and another with -output_dir");
    const tools::SmoothingResult result =
        job_.smooth (input, output, job_.threads (), tools::progressOnTerminal (), !report_.empty ());
    std::printf ("%s: %zu points\n", output.c_str (), result.points);
    if (!result.found.empty ())
      std::printf ("found: %s\n", result.found.c_str ());
    std::printf ("parameters: %s\n", result.parameters.c_str ());
    if (!report_.empty ())
      tools::saveReport (result.report, report_);
  }

  void
  smoothFolder (const tools::Options& options)
  {
    std::map<std::string, std::string> changing = options.given ();
    for (const char* name : {"-threads", "-report", "-input_dir", "-output_dir"})
      changing.erase (name);
    tools::Batch (job_, input_folder_, output_folder_, changing).run (report_);
  }

  tools::SmoothingJob job_;
  std::string report_, input_folder_, output_folder_;
};
} // namespace

int
main (int argc, char** argv)
{
  NormalSmoothingTool tool;
  return tools::runTool (argc, argv, tool);
}
