// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/viewer.h"

#include "files/output_file.h"
#include "viewer/colour_scale.h"

#include <cstdio>
#include <ctime>
#include <filesystem>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
const std::map<Colouring, std::string> names {{Colouring::DISPLACEMENT, "displacement, in the cloud's unit"},
                                              {Colouring::CURVATURE, "curvature (surface variation)"},
                                              {Colouring::DISTANCE, "distance to the mesh, in its unit"}};

std::string
format (const char* text, double first, double second)
{
  char line[120];
  std::snprintf (line, sizeof line, text, first, second);
  return line;
}
} // namespace

Viewer::Viewer (ViewerSession& session,
                const ViewerParameters& parameters,
                ViewerWindow& window,
                Colouring colouring,
                const ViewerOutputs& outputs)
: session_ (session), parameters_ (parameters), window_ (window), colouring_ (colouring), outputs_ (outputs)
{
  session_.smooth (parameters_.options ());
  parameters_.setUsed (session_.parameters ());
  show ();
}

void
Viewer::press (const std::string& key)
{
  message_.clear ();
  try {
    if (!pressOther (key) && parameters_.press (key))
      smooth ();
  }
  catch (const std::exception& error) {
    message_ = error.what ();
  }
  show ();
  window_.render ();
}

void
Viewer::smooth ()
{
  try {
    session_.smooth (parameters_.options ());
  }
  catch (...) {
    parameters_.takeBack ();
    throw;
  }
  parameters_.setUsed (session_.parameters ());
}

bool
Viewer::pressOther (const std::string& key)
{
  if (key == "h" || key == "H")
    help_ = !help_;
  else if (key == "c")
    nextColouring ();
  else if (key == "m")
    window_.switchTriangles ();
  else if (key == "+" || key == "=")
    window_.scalePoints (1.25);
  else if (key == "-")
    window_.scalePoints (0.8);
  else if (key == "r")
    window_.resetCamera ();
  else if (key == "p")
    std::printf ("%s\n", session_.parameters ().c_str ());
  else if (key == "w")
    saveSmoothed ();
  else if (key == "j")
    savePicture ("screenshot-" + std::to_string (std::time (nullptr)) + ".png");
  else if (key == "q" || key == "Escape")
    window_.close ();
  else
    return false;
  std::fflush (stdout);
  return true;
}

void
Viewer::nextColouring ()
{
  const int count = session_.hasMesh () ? 3 : 2;
  colouring_ = static_cast<Colouring> ((static_cast<int> (colouring_) + 1) % count);
}

void
Viewer::saveSmoothed ()
{
  if (outputs_.cloud.empty ())
    message_ = "nowhere to save to: begin with -save smoothed.pcd";
  else {
    saveCloud (session_.smoothedCloud (), outputs_.cloud, outputs_.format);
    message_ = "saved: " + outputs_.cloud;
  }
}

void
Viewer::savePicture (const std::string& path)
{
  OutputFile file (path);
  file.write (window_.picture ());
  file.commit ();
  const auto [width, height] = window_.size ();
  std::printf ("%s: %d x %d pixels\n", path.c_str (), width, height);
  message_ = "saved: " + path;
}

void
Viewer::show ()
{
  const auto noisy = session_.values (session_.noisy (), colouring_);
  const auto smoothed =
      colouring_ == Colouring::DISPLACEMENT ? noisy : session_.values (session_.smoothed (), colouring_);
  const double limit = scaleLimit (noisy);
  std::string before = "noisy: " + std::filesystem::path (session_.smoothedCloud ().path).filename ().string () + ", " +
                       std::to_string (session_.noisy ().nodes.size ()) + " points\n";
  std::string after = format ("smoothed in %.2f s\n", session_.seconds (), 0);
  if (colouring_ == Colouring::DISPLACEMENT)
    after += format ("moved by %.3g, at most %.3g", meanOfFinite (smoothed), largestFinite (smoothed));
  else
    for (auto [text, values] : {std::make_pair (&before, &noisy), std::make_pair (&after, &smoothed)})
      *text += format (colouring_ == Colouring::CURVATURE ? "curvature %.3g" : "distance %.3g, at most %.3g",
                       meanOfFinite (*values), largestFinite (*values));
  window_.show (ViewerWindow::LEFT, session_.noisy (), noisy, limit, before);
  window_.show (ViewerWindow::RIGHT, session_.smoothed (), smoothed, limit, after);
  const std::string hint = "h: keys" + (message_.empty () ? "" : "\n\n" + message_);
  window_.setTexts (parameters_.text (), help_ ? help () + message_ : hint, names.at (colouring_));
}

std::string
Viewer::help ()
{
  return std::string (ViewerParameters::help ()) +
         "  c m          colours: next; triangles of the mesh, or points\n"
         "  + - r        points larger, smaller; the camera as at the beginning\n"
         "  p w j        print the options; save the cloud (-save); save a picture\n"
         "  h q          this help; the end\n";
}
} // namespace tools
} // namespace pcl_normal_smoothing
