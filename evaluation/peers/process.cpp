// SPDX-License-Identifier: BSD-3-Clause
#include "process.h"

#include <sys/prctl.h>
#include <sys/wait.h>

#include <fcntl.h>
#include <spawn.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr double grace_s = 1;
// Exit statuses of coreutils' timeout.
constexpr int timed_out_status = 124;
constexpr int signal_status = 128;

double
secondsSince (Clock::time_point start)
{
  return std::chrono::duration<double> (Clock::now () - start).count ();
}

std::string
inSeconds (double seconds)
{
  std::ostringstream text;
  text << seconds << " s";
  return text.str ();
}

/** The last line of a log that is not blank or a mere notice of the crash, shortened. */
std::string
lastWords (const std::string& log)
{
  constexpr std::size_t most = 200;
  std::ifstream file (log);
  std::string words;
  for (std::string line; std::getline (file, line);)
    if (line.find_first_not_of (" \t\r") != std::string::npos && line != "Aborted" && line != "Segmentation fault")
      words = line;
  for (char& c : words)
    if (static_cast<unsigned char> (c) < ' ')
      c = ' ';
  return words.size () > most ? "..." + words.substr (words.size () - most) : words;
}

/** Why a program failed; empty if it succeeded.
  * \param[in] wait status from waitpid \param[in] log file with the program's output */
std::string
describeEnd (int wait, double seconds, double time_limit, const std::string& log)
{
  const int status = WIFSIGNALED (wait) ? signal_status + WTERMSIG (wait) : WEXITSTATUS (wait);
  if (status == 0)
    return {};
  // If timeout had to kill the group, it ends as if it had crashed.
  if (status == timed_out_status || (status == signal_status + SIGKILL && seconds >= time_limit))
    return "timed out after " + inSeconds (time_limit);
  const std::string end = status > signal_status ? std::string ("crashed (") + strsignal (status - signal_status) + ")"
                                                 : "ended with status " + std::to_string (status);
  const std::string words = lastWords (log);
  return words.empty () ? end : end + ": " + words;
}

/** Waits briefly for the remaining processes of a group, which may still be cleaning up, then kills them. */
void
endGroup (pid_t group)
{
  const auto start = Clock::now ();
  // Orphans of the group become children of this process.
  const auto isLeft = [group] {
    while (::waitpid (-group, nullptr, WNOHANG) > 0)
      ;
    return ::kill (-group, 0) == 0;
  };
  while (isLeft () && secondsSince (start) < grace_s)
    std::this_thread::sleep_for (std::chrono::milliseconds (10));
  ::kill (-group, SIGKILL);
  while (::waitpid (-group, nullptr, 0) > 0 || errno == EINTR)
    ;
}

/** The environment, with the folder for temporary files, and with OpenMP threads that leave the cores to others while
  * they wait. */
std::vector<std::string>
environmentFor (const WorkFolder& folder)
{
  std::vector<std::string> environment {"TMPDIR=" + folder.path (), "XDG_RUNTIME_DIR=" + folder.path (),
                                        "HOME=" + folder.path (), "OMP_WAIT_POLICY=passive"};
  for (char** variable = environ; *variable; ++variable) {
    const std::string text = *variable;
    const auto name = text.substr (0, text.find ('=') + 1);
    if (name != "TMPDIR=" && name != "XDG_RUNTIME_DIR=" && name != "HOME=" && name != "OMP_WAIT_POLICY=")
      environment.push_back (text);
  }
  return environment;
}

std::vector<char*>
pointersTo (std::vector<std::string>& texts)
{
  std::vector<char*> pointers;
  for (std::string& text : texts)
    pointers.push_back (text.data ());
  pointers.push_back (nullptr);
  return pointers;
}

/** \return 0, or the error number of the failure; the new program starts with default signal handling */
int
spawn (std::vector<std::string> command, const WorkFolder& folder, pid_t& process)
{
  std::vector<std::string> environment = environmentFor (folder);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init (&files);
  posix_spawn_file_actions_addchdir_np (&files, folder.path ().c_str ());
  posix_spawn_file_actions_addopen (&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen (&files, STDOUT_FILENO, "log", O_WRONLY | O_CREAT | O_TRUNC, 0600);
  posix_spawn_file_actions_adddup2 (&files, STDOUT_FILENO, STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init (&attributes);
  sigset_t all, none;
  sigfillset (&all);
  sigemptyset (&none);
  posix_spawnattr_setsigdefault (&attributes, &all);
  posix_spawnattr_setsigmask (&attributes, &none);
  posix_spawnattr_setpgroup (&attributes, 0);
  posix_spawnattr_setflags (&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
  const int error = posix_spawnp (&process, command.front ().c_str (), &files, &attributes,
                                  pointersTo (command).data (), pointersTo (environment).data ());
  posix_spawnattr_destroy (&attributes);
  posix_spawn_file_actions_destroy (&files);
  return error;
}
} // namespace

WorkFolder::WorkFolder (const std::string& parent)
{
  path_ = std::filesystem::absolute (parent) / "peer_XXXXXX";
  if (!::mkdtemp (path_.data ()))
    throw std::runtime_error ("no folder can be made in " + parent + " (" + std::strerror (errno) + ")");
}

WorkFolder::~WorkFolder ()
{
  std::error_code ignored;
  std::filesystem::remove_all (path_, ignored);
}

ProcessOutcome
runProcess (const std::vector<std::string>& command, const WorkFolder& folder, double time_limit)
{
  // coreutils' timeout ends the whole group: at the limit, or at once if this program dies before.
  std::vector<std::string> limited {"setpriv",
                                    "--pdeathsig",
                                    "TERM",
                                    "timeout",
                                    "--kill-after=" + std::to_string (grace_s),
                                    std::to_string (time_limit)};
  limited.insert (limited.end (), command.begin (), command.end ());
  const auto start = Clock::now ();
  pid_t process = 0;
  ::prctl (PR_SET_CHILD_SUBREAPER, 1); // this process inherits what a program leaves running, and can wait for it
  if (const int error = spawn (limited, folder, process))
    return {std::string ("cannot be started: ") + std::strerror (error), 0};
  int wait = 0;
  while (::waitpid (process, &wait, 0) < 0 && errno == EINTR)
    ;
  ProcessOutcome outcome;
  outcome.seconds = secondsSince (start);
  endGroup (process);
  outcome.failure = describeEnd (wait, outcome.seconds, time_limit, folder.file ("log"));
  return outcome;
}

bool
isInstalled (const std::string& program)
{
  const auto runs = [] (const std::string& file) {
    return ::access (file.c_str (), X_OK) == 0 && !std::filesystem::is_directory (file);
  };
  if (program.find ('/') != std::string::npos)
    return runs (program);
  const char* path = std::getenv ("PATH");
  std::istringstream folders (path ? path : "");
  for (std::string folder; std::getline (folders, folder, ':');)
    if (runs ((folder.empty () ? "." : folder) + '/' + program))
      return true;
  return false;
}

} // namespace pcl_normal_smoothing::evaluation
