// SPDX-License-Identifier: BSD-3-Clause
// The viewer as a user runs it, on an invisible display.
#include "tool_runner.h"
#include "viewer/display.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <X11/Xlib.h>
#include <X11/keysym.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <thread>

namespace
{
/** A PNG picture: rows from bottom to top, three bytes per pixel. */
struct Picture
{
  explicit Picture (const std::string& path)
  {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName (path.c_str ());
    reader->Update ();
    vtkImageData* image = reader->GetOutput ();
    width = image->GetDimensions ()[0];
    height = image->GetDimensions ()[1];
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c)
          bytes.push_back (static_cast<int> (image->GetScalarComponentAsDouble (x, y, 0, c)));
  }

  /** Roughness of the middle of one half: the mean difference of adjacent pixels that show the surface. */
  double
  roughness (int side) const
  {
    double sum = 0, count = 0;
    for (int y = height / 2; y < height * 4 / 5; ++y)
      for (int x = side * width / 2 + width / 8; x < side * width / 2 + width * 3 / 8; ++x) {
        const auto here = static_cast<std::size_t> (3 * (y * width + x));
        if (bytes[here] > 250 || bytes[here + 3] > 250) // the background is white
          continue;
        sum += std::abs (bytes[here] - bytes[here + 3]);
        ++count;
      }
    return count > 1000 ? sum / count : std::nan ("");
  }

  /** Share of dark pixels among those of the left view that show the surface. */
  double
  darkShare () const
  {
    double dark = 0, count = 0;
    for (int y = height / 4; y < height; ++y)
      for (int x = 0; x < width / 2; ++x) {
        const int red = bytes[static_cast<std::size_t> (3 * (y * width + x))];
        dark += red < 70 ? 1 : 0;
        count += red < 250 ? 1 : 0;
      }
    return dark / count;
  }

  int width, height;
  std::vector<int> bytes;
};

class Viewer : public ToolTest
{
protected:
  void
  SetUp () override
  {
    unsetenv ("DISPLAY"); // pictures on the viewer's own display are the same everywhere
    succeed ("pcl_make_double_torus mesh.ply");
    succeed ("pcl_add_surface_noise mesh.ply noisy.ply -type GN -sigma 0.3 -seed 1");
  }
};

/** The window with that name; 0 if there is none yet. */
Window
windowNamed (Display* display, Window parent, const std::string& name)
{
  char* title = nullptr;
  if (XFetchName (display, parent, &title) != 0 && title) {
    const bool found = name == title;
    XFree (title);
    if (found)
      return parent;
  }
  Window root, above, *children = nullptr, found = 0;
  unsigned count = 0;
  if (XQueryTree (display, parent, &root, &above, &children, &count) == 0)
    return 0;
  for (unsigned i = 0; i < count && found == 0; ++i)
    found = windowNamed (display, children[i], name);
  if (children)
    XFree (children);
  return found;
}

void
sendKey (Display* display, Window window, KeySym key, unsigned modifiers)
{
  XEvent event {};
  event.xkey.display = display;
  event.xkey.window = window;
  event.xkey.root = DefaultRootWindow (display);
  event.xkey.same_screen = True;
  event.xkey.state = modifiers;
  event.xkey.keycode = XKeysymToKeycode (display, key);
  for (const int type : {KeyPress, KeyRelease}) {
    event.type = type;
    XSendEvent (display, window, True, type == KeyPress ? KeyPressMask : KeyReleaseMask, &event);
  }
  XFlush (display);
}

/** The command of a process; empty if it has ended. */
std::string
commandOf (int process)
{
  std::string command;
  std::getline (std::ifstream ("/proc/" + std::to_string (process) + "/cmdline"), command, '\0');
  return command;
}

/** The process of the display server that a tool started; 0 if there is none within half a minute. */
int
serverOf (int tool)
{
  const std::string id = std::to_string (tool);
  for (int i = 0; i < 3000; ++i) {
    std::ifstream children ("/proc/" + id + "/task/" + id + "/children");
    for (int child; children >> child;)
      if (commandOf (child) == "Xvfb")
        return child;
    std::this_thread::sleep_for (std::chrono::milliseconds (10));
  }
  return 0;
}
} // namespace

TEST_F (Viewer, TakesAPictureWithoutADisplay)
{
  const Ending ending =
      succeed ("pcl_normal_smoothing_viewer noisy.ply mesh.ply -screenshot picture.png -width 800 -height 450");
  EXPECT_EQ (ending.out, path ("picture.png") + ": 800 x 450 pixels\n");
  const Picture picture (path ("picture.png"));
  EXPECT_EQ (picture.width, 800);
  EXPECT_EQ (picture.height, 450);
  EXPECT_LT (picture.roughness (1), 0.6 * picture.roughness (0));
}

TEST_F (Viewer, DrawsPointsWithLight)
{
  const std::string points = "pcl_normal_smoothing_viewer noisy.ply -width 800 -height 450 ";
  succeed (points + "-screenshot picture.png -color_by curvature");
  const Picture picture (path ("picture.png"));
  EXPECT_LT (picture.roughness (1), 0.8 * picture.roughness (0));
  succeed (points + "-screenshot still.png -point_iterations 0"); // grey, as nothing moves
  const Picture still (path ("still.png"));
  EXPECT_GT (still.roughness (0), 1);
  EXPECT_NEAR (still.roughness (1), still.roughness (0), 0.05 * still.roughness (0));
  EXPECT_LT (still.darkShare (), 0.1); // surfaces with normals that point away are lit, too
}

TEST_F (Viewer, SaysWhatItCannotDo)
{
  EXPECT_EQ (run ("pcl_normal_smoothing_viewer noisy.ply -screenshot picture.jpg").status, 1);
  EXPECT_EQ (run ("pcl_normal_smoothing_viewer noisy.ply -screenshot picture.png -color_by distance").status, 1);
  EXPECT_EQ (run ("pcl_normal_smoothing_viewer noisy.ply mesh.ply more.ply").status, 1);
  EXPECT_EQ (run ("pcl_normal_smoothing_viewer none.ply -screenshot picture.png").status, 2);
  const Ending without_display = run ("pcl_normal_smoothing_viewer noisy.ply");
  EXPECT_EQ (without_display.status, 3);
  EXPECT_NE (without_display.err.find ("-screenshot"), std::string::npos) << without_display.err;
  EXPECT_EQ (files (), (std::set<std::string> {"mesh.ply", "noisy.ply"}));
}

TEST_F (Viewer, KilledItLeavesNoDisplayBehind)
{
  for (const int signal : {SIGTERM, SIGKILL}) {
    RunningTool tool ({TOOLS_FOLDER "/pcl_normal_smoothing_viewer", path ("noisy.ply"), "-screenshot",
                       path ("picture.png")},
                      folder_);
    const int server = serverOf (tool.number ());
    ASSERT_NE (server, 0);
    tool.send (signal);
    EXPECT_EQ (tool.wait ().status, 128 + signal);
    for (int i = 0; i < 1000 && !commandOf (server).empty (); ++i)
      std::this_thread::sleep_for (std::chrono::milliseconds (10));
    EXPECT_EQ (commandOf (server), "") << "after signal " << signal;
  }
}

TEST_F (Viewer, KeysChangeTheParameters)
{
  const pcl_normal_smoothing::tools::Display server (true);
  Display* display = XOpenDisplay (nullptr);
  ASSERT_NE (display, nullptr);
  RunningTool tool ({TOOLS_FOLDER "/pcl_normal_smoothing_viewer", path ("noisy.ply"), "-save", path ("out.ply"),
                     "-width", "600", "-height", "400"},
                    folder_);
  Window window = 0;
  for (int i = 0; i < 300 && window == 0; ++i) {
    std::this_thread::sleep_for (std::chrono::milliseconds (100));
    window = windowNamed (display, DefaultRootWindow (display), "pcl_normal_smoothing_viewer");
  }
  ASSERT_NE (window, 0u);
  std::this_thread::sleep_for (std::chrono::seconds (2));
  for (const KeySym key : {XK_K, XK_p, XK_h, XK_c, XK_2, XK_Right, XK_p, XK_w, XK_q})
    sendKey (display, window, key, key == XK_K ? ShiftMask : 0);
  const Ending ending = tool.wait ();
  XCloseDisplay (display);
  EXPECT_EQ (ending.status, 0) << ending.err;
  const std::string second = ending.out.substr (ending.out.find ('\n') + 1);
  EXPECT_NE (ending.out.find ("-preset default -normals wpca -k 40"), std::string::npos) << ending.out;
  EXPECT_NE (second.find ("-preset fast -normals wpca -k 20"), std::string::npos) << ending.out;
  EXPECT_EQ (succeed ("pcl_normal_smoothing noisy.ply expected.ply -preset fast -k 20").status, 0);
  EXPECT_TRUE (contentOf (path ("out.ply")) == contentOf (path ("expected.ply")));
}
