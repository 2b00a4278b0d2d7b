// SPDX-License-Identifier: BSD-3-Clause
#include "tool.h"

#include "files/output_file.h"
#include "files/signal_pause.h"
#include "files/tool_error.h"

#include <pcl/console/print.h>

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
enum ExitStatus
{
  DONE = 0,
  WRONG_USAGE = 1,
  FILE_TROUBLE = 2,
  DATA_TROUBLE = 3
};

std::string tool_name;

/** Ends the tool at once, whatever it does: a flag would not be seen during a long search, or while a pipe is full.
  * Makes only calls that are safe in a signal handler. */
extern "C" void
endInterrupted (int signal)
{
  SignalPause::endAll ();
  removeTemporaryFile ();
  _exit (128 + signal);
}

void
handleSignals ()
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before;
    sigaction (signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) // as in the background, or under nohup
      continue;
    struct sigaction action
    {};
    action.sa_handler = endInterrupted;
    sigfillset (&action.sa_mask);
    sigaction (signal, &action, nullptr);
  }
  // So that a file at its size limit and a pipe without a reader are ordinary write errors.
  for (const int signal : {SIGXFSZ, SIGPIPE})
    std::signal (signal, SIG_IGN);
}

int
fail (ExitStatus status, const std::string& message)
{
  note (message);
  return status;
}
} // namespace

void
note (const std::string& message)
{
  std::fprintf (stderr, "%s: %s\n", tool_name.c_str (), message.c_str ());
}

std::string
counted (std::uint64_t number, const std::string& one, const std::string& more)
{
  return std::to_string (number) + " " + (number == 1 ? one : more.empty () ? one + "s" : more);
}

ProgressCallback
progressOnTerminal ()
{
  if (!isatty (STDERR_FILENO))
    return {};
  // Shared: the stages of the work keep copies of the callback.
  return [shown = std::make_shared<int> (-1)] (double done) {
    const int percent = static_cast<int> (100 * done);
    if (percent != *shown)
      std::fprintf (stderr, percent < 100 ? "\r%3d %%" : "\r     \r", percent);
    *shown = percent;
    return true;
  };
}

int
exitStatusOf (const std::string& file, const std::function<void ()>& work)
{
  try {
    work ();
    if (std::fflush (stdout) != 0 && errno == EPIPE)
      return FILE_TROUBLE; // the reader wants no more: no message
    if (std::ferror (stdout) != 0)
      throw FileError ("the standard output", "cannot be written", "free some space, or send it elsewhere");
    return DONE;
  }
  catch (const UsageError& error) {
    return fail (WRONG_USAGE, error.what ());
  }
  catch (const FileError& error) {
    return fail (FILE_TROUBLE, error.what ());
  }
  catch (const std::filesystem::filesystem_error& error) {
    return fail (FILE_TROUBLE, error.path1 ().string () + ": " + error.code ().message () + ": give another path");
  }
  catch (const std::bad_alloc&) {
    return fail (DATA_TROUBLE, file + ": there is not enough memory: give it in parts, or take a smaller k");
  }
  catch (const std::exception& error) {
    return fail (DATA_TROUBLE, file + ": " + error.what ());
  }
}

int
runTool (int argc, char** argv, Tool& tool)
{
  tool_name = std::filesystem::path (argv[0]).filename ().string ();
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); // this file prints all messages
  handleSignals ();
  Options options;
  bool work = false;
  const int status = exitStatusOf (tool_name, [&] {
    tool.describe (options);
    work = options.parse (argc, argv);
  });
  return work && status == DONE ? exitStatusOf (options.file (0), [&] { tool.work (options); }) : status;
}
} // namespace tools
} // namespace pcl_normal_smoothing
