// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/visualization/interactor_style.h>

#include <functional>
#include <string>

namespace pcl_normal_smoothing
{
namespace tools
{
/** PCL's mouse interaction with keys of our own: PCL's switch colour handlers, and there are none here. */
class ViewerStyle : public pcl::visualization::PCLVisualizerInteractorStyle
{
public:
  static ViewerStyle*
  New ();

  /** Called with the character of a key ("K", "+") or its name in X ("Up"). */
  std::function<void (const std::string&)> pressed;

protected:
  void
  OnKeyDown () override;

  void
  OnKeyUp () override
  {}

  void
  OnChar () override
  {}

public: // last: a semicolon after the macro is a warning, and without one clang-format misreads what follows it
  vtkTypeMacro (ViewerStyle, pcl::visualization::PCLVisualizerInteractorStyle)
};
} // namespace tools
} // namespace pcl_normal_smoothing
