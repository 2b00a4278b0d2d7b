// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

struct _XDisplay; // Xlib's

namespace pcl_normal_smoothing
{
namespace tools
{
/** A display for VTK, which ends the program if it finds none. */
class Display
{
public:
  /** Uses the existing display, if there is one.
    * \param[in] off_screen if there is none, starts Xvfb, a virtual display, until this object is destroyed or the
    * program ends, in whatever way
    * \throw core::Error that says what to do, if there is no display */
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
  _XDisplay* connection_ = nullptr; // to the server, which ends with its last client
};
} // namespace tools
} // namespace pcl_normal_smoothing
