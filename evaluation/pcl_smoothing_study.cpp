// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/tool.h"
#include "files/tool_error.h"
#include "study/study_options.h"

#include <cstdio>

using namespace pcl_normal_smoothing;

namespace
{
class StudyTool : public tools::Tool
{
public:
  explicit StudyTool (const std::string& command_line)
  {
    study_.command_line = command_line;
  }

private:
  void
  describe (tools::Options& options) override
  {
    options.describe (
        "Repeats the study of the paper: adds noise to meshes, smooths them by many methods, measures.\n"
        "Writes rows.csv, rows.json, study.json, models/ and clouds/ into the folder; interrupted, the same\n"
        "command goes on where it stopped.",
        {"folder", "[mesh.ply|off|obj|stl]..."});
    evaluation::addStudyOptions (options, study_);
  }

  void
  work (const tools::Options& options) override
  {
    evaluation::readStudyFiles (options, study_);
    const evaluation::StudyCounts rows = evaluation::runStudy (study_);
    std::printf ("%s/rows.csv: %zu rows, %zu failed, %zu absent\n", study_.folder.c_str (),
                 rows.ok + rows.failed + rows.absent, rows.failed, rows.absent);
  }

  evaluation::StudyOptions study_;
};
} // namespace

int
main (int argc, char** argv)
{
  std::string command_line = "pcl_smoothing_study";
  for (int i = 1; i < argc; ++i)
    command_line += std::string (" ") + argv[i];
  StudyTool tool (command_line);
  return tools::runTool (argc, argv, tool);
}
