// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/visualization/interactor_style.h>

#include <functional>
#include <string>

namespace pcl_normal_smoothing
{
namespace tools
{
/** PCL's mouse, and keys of one's own: PCL's would switch handlers that there are none of. */
class ViewerStyle : public pcl::visualization::PCLVisualizerInteractorStyle
{
public:
  static ViewerStyle*
  New ();

  /** Called with what a key stands for, "K" or "+", or with its name in X, "Up". */
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

public: // at the end: a semicolon behind it is a warning, and without one clang-format takes what follows for its rest
  vtkTypeMacro (ViewerStyle, pcl::visualization::PCLVisualizerInteractorStyle)
};
} // namespace tools
} // namespace pcl_normal_smoothing
