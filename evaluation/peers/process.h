// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_normal_smoothing::evaluation
{

/** A folder of its own for one run, which goes with all that is in it. */
class WorkFolder
{
public:
  /** \param[in] parent exists \throw std::runtime_error where no folder can be made in it */
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
  /** Empty where it ended with status 0, else what happened, with the last that it said. */
  std::string failure;
  /** Wall time. */
  double seconds = 0;
};

/** Runs a program in a process group of its own, with the folder as its current one and as its place for temporary
  * files; it reads nothing, and what it prints goes to the file "log" there. When this returns, the whole group is
  * gone.
  * \param[in] command the program, looked up in PATH, and its arguments
  * \param[in] time_limit in seconds, after which the group is ended */
ProcessOutcome
runProcess (const std::vector<std::string>& command, const WorkFolder& folder, double time_limit);

/** The program is a file that can be run, or PATH has one of that name. */
bool
isInstalled (const std::string& program);

} // namespace pcl_normal_smoothing::evaluation
