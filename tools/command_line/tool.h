// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <pcl_normal_smoothing/core/parallel_for.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A command-line tool: what lies between its command line and its exit status. */
class Tool
{
public:
  virtual ~Tool () = default;

  /** Says what the tool is for, and adds its options. */
  virtual void
  describe (Options& options) = 0;

  /** Called when the command line has been read.
    * \throw UsageError: exit status 1; FileError: 2; any other exception: 3, with the first file named in the
    * message */
  virtual void
  work (const Options& options) = 0;
};

/** The main function of every tool: parses, works, turns whatever is thrown into one message and an exit status.
  * Interrupted, the tool leaves nothing behind. */
int
runTool (int argc, char** argv, Tool& tool);

/** Does some work, and turns whatever it throws into a message and an exit status as runTool does.
  * \param[in] file named in the message where the data cannot be worked on */
int
exitStatusOf (const std::string& file, const std::function<void ()>& work);

/** Shows on the terminal how far the work is; empty where stderr is no terminal. */
ProgressCallback
progressOnTerminal ();

/** "1 file", "2 files". \param[in] more the plural of \a one that is not just an s longer */
std::string
counted (std::uint64_t number, const std::string& one, const std::string& more = {});

/** A message on stderr that is no error. */
void
note (const std::string& message);
} // namespace tools
} // namespace pcl_normal_smoothing
