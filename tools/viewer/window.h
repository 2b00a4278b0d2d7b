// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewer/extent.h"
#include "viewer/surface_actor.h"

#include <pcl/visualization/pcl_visualizer.h>

#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>

#include <array>

namespace pcl_normal_smoothing
{
namespace tools
{
class ViewerStyle;

/** Initial settings of a window. */
struct WindowSettings
{
  int width = 1600;
  int height = 900;
  /** No window appears: only a picture of it is wanted. */
  bool off_screen = false;

  /** -width -height */
  void
  addTo (Options& options);
};

/** PCL's visualizer with two surfaces side by side, one camera for both, and a strip of text below them. */
class ViewerWindow
{
public:
  enum Side
  {
    LEFT,
    RIGHT
  };

  /** \param[in] surface at which the camera looks
    * \param[in] viewpoint of the sensor
    * \param[in] spacing of points, which are drawn large enough to close the gaps between them */
  ViewerWindow (const WindowSettings& settings,
                const Surface& surface,
                const std::vector<Mesh::Triangle>& triangles,
                const Eigen::Vector3d& viewpoint,
                double spacing);

  ~ViewerWindow ();

  /** \param[in] limit end of the colour scale \param[in] title above the surface */
  void
  show (Side side, const Surface& surface, const std::vector<float>& values, double limit, const std::string& title);

  /** Sets the two texts of the strip, and the title of its colour scale. */
  void
  setTexts (const std::string& left, const std::string& right, const std::string& colours);

  /** Switches between triangles, if there are any, and points. */
  void
  switchTriangles ();

  /** Multiplies the size of the points, which otherwise just closes the gaps. */
  void
  scalePoints (double factor);

  void
  resetCamera ();

  void
  render ();

  /** The picture as the bytes of a PNG file. */
  std::string
  picture ();

  /** Its width and height, in pixels. */
  std::array<int, 2>
  size () const;

  /** Calls \a pressed for every key, until close() is called or the user closes the window. */
  void
  run (const std::function<void (const std::string& key)>& pressed);

  void
  close ();

private:
  void
  addViews ();

  void
  addStrip ();

  void
  fitPoints ();

  vtkRenderer*
  renderer (int number) const;

  vtkSmartPointer<vtkTextActor>
  addText (int renderer, double x, double y, bool fixed_width);

  Extent extent_;
  Eigen::Vector3d viewpoint_;
  double spacing_;
  double point_scale_ = 1.7;
  int font_size_;
  bool triangles_ = true;
  vtkSmartPointer<vtkLookupTable> colours_;
  std::array<SurfaceActor, 2> surfaces_;
  std::array<vtkSmartPointer<vtkTextActor>, 2> titles_;
  vtkSmartPointer<vtkTextActor> left_text_, right_text_;
  vtkSmartPointer<vtkScalarBarActor> bar_;
  vtkSmartPointer<ViewerStyle> style_;
  std::unique_ptr<pcl::visualization::PCLVisualizer> visualizer_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
