// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

namespace pcl_normal_smoothing
{
namespace tools
{
/** A display for VTK, which ends the program where it finds none. */
class Display
{
public:
  /** Takes the display that there is.
    * \param[in] off_screen without one, starts Xvfb, a display that nobody sees, until this object goes
    * \throw core::Error that says what to do where there is none */
  explicit Display (bool off_screen);

  ~Display ();

  Display (const Display&) = delete;
  Display&
  operator= (const Display&) = delete;

private:
  void
  startServer ();

  pid_t server_ = -1;
};
} // namespace tools
} // namespace pcl_normal_smoothing
