// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/style.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

namespace pcl_normal_smoothing
{
namespace tools
{
vtkStandardNewMacro (ViewerStyle)

    void ViewerStyle::OnKeyDown ()
{
  const char* key = Interactor->GetKeySym ();
  if (key && pressed)
    pressed (key);
}
} // namespace tools
} // namespace pcl_normal_smoothing
