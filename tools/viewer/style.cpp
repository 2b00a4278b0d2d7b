// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/style.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <cctype>

namespace pcl_normal_smoothing
{
namespace tools
{
vtkStandardNewMacro (ViewerStyle);

void
ViewerStyle::OnKeyDown ()
{
  // PCL's interactor reports the key regardless of Shift.
  const int code = static_cast<unsigned char> (Interactor->GetKeyCode ());
  const char* name = Interactor->GetKeySym ();
  const bool shift = Interactor->GetShiftKey () != 0;
  if (pressed && std::isgraph (code))
    pressed (std::string (1, static_cast<char> (shift ? std::toupper (code) : code)));
  else if (pressed && name)
    pressed (name);
}
} // namespace tools
} // namespace pcl_normal_smoothing
