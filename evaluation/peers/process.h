// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** A folder for one run, removed together with its contents. */
class WorkFolder
{
public:
  /** \param[in] parent must exist \throw std::runtime_error if no folder can be made in it */
  explicit WorkFolder (const std::string& parent);

  ~WorkFolder ();

  WorkFolder (const WorkFolder&) = delete;
  WorkFolder&
  operator= (const WorkFolder&) = delete;

  /** The absolute path of a file in it. */
  std::string
  file (const std::string& name) const
  {
    return path_ + '/' + name;
  }

  const std::string&
  path () const
  {
    return path_;
  }

private:
  std::string path_;
};

/** How a program ended. */
struct ProcessOutcome
{
  /** Empty if it ended with status 0, otherwise what happened, with the last line that it printed. */
  std::string failure;
  /** Wall time. */
  double seconds = 0;
};

/** Runs a program in its own process group, with the folder as working directory and for temporary files. Its input is
  * empty, and its output goes to the file "log" there. When this returns, no process of the group is left.
  * \param[in] command the program, looked up in PATH, and its arguments
  * \param[in] time_limit in seconds, after which the group is ended */
ProcessOutcome
runProcess (const std::vector<std::string>& command, const WorkFolder& folder, double time_limit);

/** Whether the program is an executable file, or PATH has one of that name. */
bool
isInstalled (const std::string& program);

} // namespace pcl_normal_smoothing::evaluation
