// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/display.h"

#include <pcl_normal_smoothing/core/error.h>

#include <X11/Xlib.h>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <string>

extern char** environ;

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr int patience_ms = 30000;

bool
displayThere ()
{
  ::Display* display = XOpenDisplay (nullptr);
  if (display)
    XCloseDisplay (display);
  return display != nullptr;
}

/** The display number that the server writes when it is ready; empty if it never does. */
std::string
numberFrom (int pipe)
{
  std::string number;
  pollfd waiting {pipe, POLLIN, 0};
  char digit = 0;
  while (poll (&waiting, 1, patience_ms) > 0 && read (pipe, &digit, 1) == 1 && digit != '\n')
    number += digit;
  return digit == '\n' ? number : std::string ();
}
} // namespace

Display::Display (bool off_screen)
{
  if (displayThere ())
    return;
  if (!off_screen)
    throw core::Error ("there is no display for a window: set DISPLAY, or take a picture with -screenshot");
  startServer ();
}

Display::~Display ()
{
  if (server_ > 0)
    stopServer ();
}

void
Display::startServer ()
{
  int ends[2];
  if (pipe (ends) != 0)
    throw core::Error ("no pipe can be made for a display: close some files");
  fcntl (ends[0], F_SETFD, FD_CLOEXEC); // the server must not inherit the reading end
  const std::string end = std::to_string (ends[1]);
  // It ends with its last client, or if nobody reads its number: it does not outlive a program that is killed.
  const char* const words[] = {"Xvfb",     "-displayfd", end.c_str (), "-screen",    "0",
                               "64x64x24", "-nolisten",  "tcp",        "-terminate", nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init (&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen (&actions, stream, "/dev/null", stream == STDIN_FILENO ? 0 : 1, 0);
  const bool started =
      posix_spawnp (&server_, words[0], &actions, nullptr, const_cast<char* const*> (words), environ) == 0;
  posix_spawn_file_actions_destroy (&actions);
  ::close (ends[1]);
  const std::string number = started ? numberFrom (ends[0]) : std::string ();
  ::close (ends[0]);
  if (!number.empty ())
    setenv ("DISPLAY", (":" + number).c_str (), 1);
  connection_ = number.empty () ? nullptr : XOpenDisplay (nullptr);
  if (connection_ == nullptr) {
    if (started)
      stopServer ();
    throw core::Error ("there is no display, and Xvfb does not start: install xvfb, or set DISPLAY");
  }
}

void
Display::stopServer ()
{
  if (connection_)
    XCloseDisplay (connection_);
  kill (server_, SIGTERM);
  waitpid (server_, nullptr, 0);
  unsetenv ("DISPLAY"); // it was not set before, and another server may get the number
}
} // namespace tools
} // namespace pcl_normal_smoothing
