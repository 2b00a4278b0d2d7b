// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/tool.h"
#include "files/output_file.h"
#include "files/tool_error.h"
#include "viewer/display.h"
#include "viewer/viewer.h"

using namespace pcl_normal_smoothing;

namespace
{
const tools::Words<tools::Colouring> colourings {{"displacement", tools::Colouring::DISPLACEMENT},
                                                 {"curvature", tools::Colouring::CURVATURE},
                                                 {"distance", tools::Colouring::DISTANCE}};

class ViewerTool : public tools::Tool
{
  void
  describe (tools::Options& options) override
  {
    options.describe ("Shows a noisy cloud and what smoothing makes of it side by side; keys change the parameters.\n" +
                          std::string (tools::presets_and_chain) + "\n\nKeys:\n" + tools::Viewer::help (),
                      {"input.pcd|ply", "[mesh.ply|off|obj|stl]"});
    options.add ("-color_by", wordList (colourings), "what colours tell; distance: to the mesh, the true surface",
                 "displacement", tools::choiceOption<tools::Colouring> (colourings, [&] (auto c) { colouring_ = c; }));
    const auto into = [] (std::string& text) { return [&text] (const std::string& given) { text = given; }; };
    options.add ("-screenshot", "F.png", "write a picture and end; needs no display where Xvfb is installed", "none",
                 into (picture_));
    window_.addTo (options);
    options.add ("-save", "output.pcd|ply", "where the key w writes the smoothed cloud", "none", into (save_));
    job_.addOptions (options);
  }

  void
  work (const tools::Options& options) override
  {
    check (options);
    window_.off_screen = !picture_.empty ();
    tools::ViewerSession session (options.file (0), options.file (1));
    const tools::Display display (window_.off_screen);
    tools::ViewerParameters::Given method = options.given ();
    for (const char* name : {"-color_by", "-screenshot", "-width", "-height", "-save"})
      method.erase (name);
    tools::ViewerWindow window (window_, session.noisy (), session.triangles (), session.viewpoint (),
                                session.spacing ());
    tools::Viewer viewer (session, tools::ViewerParameters (method, options), window, colouring_,
                          {save_, job_.format ()});
    if (window_.off_screen)
      viewer.savePicture (picture_);
    else
      window.run ([&] (const std::string& key) { viewer.press (key); });
  }

  void
  check (const tools::Options& options) const
  {
    job_.check (options);
    if (!picture_.empty () && tools::extensionOf (picture_) != ".png")
      throw tools::UsageError (picture_ + ": a picture is a PNG: end its name in .png");
    if (colouring_ == tools::Colouring::DISTANCE && options.file (1).empty ())
      throw tools::UsageError ("-color_by distance has no mesh to measure to: name one behind the cloud");
    if (!picture_.empty ())
      tools::checkWritable (picture_);
    if (!save_.empty ())
      tools::checkOutput (save_, job_.format ());
  }

  tools::SmoothingJob job_;
  tools::Colouring colouring_ = tools::Colouring::DISPLACEMENT;
  tools::WindowSettings window_;
  std::string picture_, save_;
};
} // namespace

int
main (int argc, char** argv)
{
  ViewerTool tool;
  return tools::runTool (argc, argv, tool);
}
