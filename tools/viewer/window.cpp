// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/window.h"

#include "viewer/colour_scale.h"
#include "viewer/style.h"

#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkLight.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr double strip_height = 0.21; // as a share of the window's
constexpr double text_colour[] = {0.15, 0.15, 0.17};
constexpr int strip = 0; // the first renderer of PCLVisualizer
constexpr int window_samples = 8;
constexpr double margin = 1.06; // factor, around the surface
constexpr double radians = M_PI / 180;

struct Looking
{
  Eigen::Vector3d from, up; // from: direction towards the camera
};

/** From the sensor's side if all points lie in front of it, as with a depth camera (z forward, y down); otherwise from
  * somewhat above, with z up for ground, which is wider than high, or else y up, as in most meshes. */
Looking
lookingAt (const Extent& extent, const Eigen::Vector3d& viewpoint)
{
  const bool depth_camera = viewpoint.isZero () && extent.centre ().z () > extent.half ().z ();
  if (depth_camera)
    return {{0, 0, -1}, {0, -1, 0}};
  if (extent.half ().z () < 0.6 * std::min (extent.half ().x (), extent.half ().y ()))
    return {Eigen::Vector3d (-0.35, -1, 0.8).normalized (), {0, 0, 1}};
  return {Eigen::Vector3d (0.45, 0.4, 1).normalized (), {0, 1, 0}};
}
/** From the upper left and, weaker, from the lower right: a light at the camera alone shows no roughness. */
void
addLights (vtkRenderer* renderer)
{
  renderer->AutomaticLightCreationOff ();
  for (const auto& [x, y, z, strength] :
       {std::make_tuple (-0.4, 0.5, 1.0, 0.75), std::make_tuple (0.8, -0.3, 0.8, 0.4)}) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight ();
    light->SetPosition (x, y, z);
    light->SetFocalPoint (0, 0, 0);
    light->SetIntensity (strength);
    renderer->AddLight (light);
  }
}
} // namespace

void
WindowSettings::addTo (Options& options)
{
  options.add ("-width", "N", "of window and picture, in pixels", std::to_string (width),
               integerOption (400, 8000, [this] (auto n) { width = static_cast<int> (n); }));
  options.add ("-height", "N", "of window and picture, in pixels", std::to_string (height),
               integerOption (300, 8000, [this] (auto n) { height = static_cast<int> (n); }));
}

ViewerWindow::ViewerWindow (const WindowSettings& settings,
                            const Surface& surface,
                            const std::vector<Mesh::Triangle>& triangles,
                            const Eigen::Vector3d& viewpoint,
                            double spacing)
: extent_ (surface)
, viewpoint_ (viewpoint)
, spacing_ (spacing)
, font_size_ (std::max (9, settings.height / 62))
, colours_ (makeColours ())
, surfaces_ {SurfaceActor (extent_.centre (), triangles, colours_),
             SurfaceActor (extent_.centre (), triangles, colours_)}
, style_ (vtkSmartPointer<ViewerStyle>::New ())
{
  int no_arguments = 0;
  visualizer_ =
      std::make_unique<pcl::visualization::PCLVisualizer> (no_arguments, nullptr, "pcl_normal_smoothing_viewer", style_,
                                                           !settings.off_screen);
  visualizer_->setShowFPS (false);
  visualizer_->getRenderWindow ()->SetOffScreenRendering (settings.off_screen ? 1 : 0);
  visualizer_->getRenderWindow ()->SetMultiSamples (window_samples);
  visualizer_->setSize (settings.width, settings.height);
  addViews ();
  addStrip ();
  resetCamera ();
}

ViewerWindow::~ViewerWindow () = default;

vtkRenderer*
ViewerWindow::renderer (int number) const
{
  return static_cast<vtkRenderer*> (visualizer_->getRendererCollection ()->GetItemAsObject (number));
}

void
ViewerWindow::addViews ()
{
  for (const int side : {LEFT, RIGHT}) {
    int viewport = 0;
    visualizer_->createViewPort (0.5 * side, strip_height, 0.5 * (side + 1), 1, viewport);
    renderer (viewport)->SetBackground (1, 1, 1);
    addLights (renderer (viewport));
    renderer (viewport)->AddActor (surfaces_[static_cast<std::size_t> (side)].actor ());
    titles_[static_cast<std::size_t> (side)] = addText (viewport, 0.02, 0.98, false);
  }
}

void
ViewerWindow::addStrip ()
{
  renderer (strip)->SetViewport (0, 0, 1, strip_height);
  renderer (strip)->SetInteractive (0);
  renderer (strip)->SetBackground (0.94, 0.94, 0.95);
  left_text_ = addText (strip, 0.01, 0.95, true);
  right_text_ = addText (strip, 0.25, 0.95, true);
  bar_ = vtkSmartPointer<vtkScalarBarActor>::New ();
  bar_->SetLookupTable (colours_);
  bar_->SetOrientationToHorizontal ();
  bar_->SetNumberOfLabels (4);
  bar_->SetLabelFormat ("%.3g");
  bar_->SetTextPositionToPrecedeScalarBar ();
  bar_->SetVerticalTitleSeparation (font_size_ / 2);
  bar_->UnconstrainedFontSizeOn ();
  bar_->GetPositionCoordinate ()->SetValue (0.74, 0.25);
  bar_->GetPosition2Coordinate ()->SetValue (0.24, 0.6);
  for (vtkTextProperty* text : {bar_->GetTitleTextProperty (), bar_->GetLabelTextProperty ()}) {
    text->SetColor (text_colour[0], text_colour[1], text_colour[2]);
    text->SetFontSize (font_size_);
    text->BoldOff ();
    text->ItalicOff ();
    text->ShadowOff ();
  }
  renderer (strip)->AddActor2D (bar_);
}

vtkSmartPointer<vtkTextActor>
ViewerWindow::addText (int number, double x, double y, bool fixed_width)
{
  auto text = vtkSmartPointer<vtkTextActor>::New ();
  text->GetPositionCoordinate ()->SetCoordinateSystemToNormalizedViewport ();
  text->SetPosition (x, y);
  vtkTextProperty* look = text->GetTextProperty ();
  look->SetColor (text_colour[0], text_colour[1], text_colour[2]);
  look->SetFontSize (fixed_width ? font_size_ : font_size_ + 2);
  look->SetVerticalJustificationToTop ();
  if (fixed_width)
    look->SetFontFamilyToCourier ();
  renderer (number)->AddActor2D (text);
  return text;
}

void
ViewerWindow::show (Side side,
                    const Surface& surface,
                    const std::vector<float>& values,
                    double limit,
                    const std::string& title)
{
  surfaces_[side].set (surface, values, limit);
  titles_[side]->SetInput (title.c_str ());
  colours_->SetRange (0, limit);
}

void
ViewerWindow::setTexts (const std::string& left, const std::string& right, const std::string& colours)
{
  left_text_->SetInput (left.c_str ());
  right_text_->SetInput (right.c_str ());
  bar_->SetTitle (colours.c_str ());
}

void
ViewerWindow::switchTriangles ()
{
  triangles_ = !triangles_;
  for (SurfaceActor& surface : surfaces_)
    surface.drawTriangles (triangles_);
}

void
ViewerWindow::scalePoints (double factor)
{
  point_scale_ *= factor;
}

void
ViewerWindow::resetCamera ()
{
  const Looking looking = lookingAt (extent_, viewpoint_);
  vtkCamera* camera = renderer (1 + LEFT)->GetActiveCamera ();
  const int* size = visualizer_->getRenderWindow ()->GetSize ();
  const double aspect = 0.5 * size[0] / ((1 - strip_height) * size[1]);
  const double slope = std::tan (camera->GetViewAngle () / 2 * radians) / margin;
  Eigen::Matrix3d axes;
  axes.col (0) = looking.up.cross (looking.from).normalized ();
  axes.col (1) = looking.from.cross (axes.col (0));
  axes.col (2) = looking.from;
  const Eigen::Vector3d place = extent_.cameraPlace (axes, slope * aspect, slope);
  const Eigen::Vector3d focus = place - place.dot (looking.from) * looking.from; // at the depth of the centre
  camera->SetFocalPoint (focus.x (), focus.y (), focus.z ());
  camera->SetPosition (place.x (), place.y (), place.z ());
  camera->SetViewUp (looking.up.x (), looking.up.y (), looking.up.z ());
}

void
ViewerWindow::fitPoints ()
{
  vtkCamera* camera = renderer (1 + LEFT)->GetActiveCamera ();
  const double height = (1 - strip_height) * visualizer_->getRenderWindow ()->GetSize ()[1];
  const double seen = 2 * camera->GetDistance () * std::tan (camera->GetViewAngle () / 2 * radians);
  for (SurfaceActor& surface : surfaces_)
    surface.setPointSize (std::clamp (point_scale_ * spacing_ * height / seen, 1.0, 40.0));
}

void
ViewerWindow::render ()
{
  fitPoints ();
  for (const int view : {1 + LEFT, 1 + RIGHT})
    renderer (view)->ResetCameraClippingRange ();
  visualizer_->getRenderWindow ()->Render ();
}

std::string
ViewerWindow::picture ()
{
  render ();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput (visualizer_->getRenderWindow ());
  image->ReadFrontBufferOff ();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection (image->GetOutputPort ());
  writer->WriteToMemoryOn ();
  writer->Write ();
  vtkUnsignedCharArray* bytes = writer->GetResult ();
  return {reinterpret_cast<const char*> (bytes->GetPointer (0)),
          static_cast<std::size_t> (bytes->GetNumberOfValues ())};
}

std::array<int, 2>
ViewerWindow::size () const
{
  const int* size = visualizer_->getRenderWindow ()->GetSize ();
  return {size[0], size[1]};
}

void
ViewerWindow::run (const std::function<void (const std::string& key)>& pressed)
{
  style_->pressed = pressed;
  render ();
  visualizer_->spin ();
}

void
ViewerWindow::close ()
{
  style_->GetInteractor ()->TerminateApp (); // PCLVisualizer::close of 1.13 uses the display after closing it
}
} // namespace tools
} // namespace pcl_normal_smoothing
