// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"

#include <pcl_normal_smoothing/core/parallel_for.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A command-line tool, without its main function. */
class Tool
{
public:
  virtual ~Tool () = default;

  /** Says what the tool is for, and adds its options. */
  virtual void
  describe (Options& options) = 0;

  /** Called once the command line has been parsed.
    * \throw UsageError: exit status 1; FileError, std::filesystem::filesystem_error: 2; any other exception: 3, with
    * the first file named in the message */
  virtual void
  work (const Options& options) = 0;
};

/** The main function of every tool: parses, works, turns whatever is thrown into one message and an exit status.
  * If it is interrupted, it leaves nothing behind. */
int
runTool (int argc, char** argv, Tool& tool);

/** Does some work, and turns whatever it throws into a message and an exit status as runTool does.
  * \param[in] file named in the message if its data cannot be processed */
int
exitStatusOf (const std::string& file, const std::function<void ()>& work);

/** A callback that shows the progress on the terminal; empty if stderr is not a terminal. */
ProgressCallback
progressOnTerminal ();

/** "1 file", "2 files". \param[in] more the plural of \a one, if it takes more than an s */
std::string
counted (std::uint64_t number, const std::string& one, const std::string& more = {});

/** Prints a message on stderr, with the tool's name. */
void
note (const std::string& message);
} // namespace tools
} // namespace pcl_normal_smoothing
