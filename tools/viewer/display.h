// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

struct _XDisplay; // Xlib's

namespace pcl_normal_smoothing
{
namespace tools
{
/** A display for VTK, which ends the program where it finds none. */
class Display
{
public:
  /** Takes the display that there is.
    * \param[in] off_screen without one, starts Xvfb, a display that nobody sees, until this object goes or the program
    * ends, however it does
    * \throw core::Error that says what to do where there is none */
  explicit Display (bool off_screen);

  ~Display ();

  Display (const Display&) = delete;
  Display&
  operator= (const Display&) = delete;

private:
  void
  startServer ();

  void
  stopServer ();

  pid_t server_ = -1;
  _XDisplay* connection_ = nullptr; // to the server, which ends when its last client goes
};
} // namespace tools
} // namespace pcl_normal_smoothing
