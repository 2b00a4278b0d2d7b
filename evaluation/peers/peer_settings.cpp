// SPDX-License-Identifier: BSD-3-Clause
#include "peer.h"

#include <sstream>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
struct Value
{
  std::string name;
  double value;
  std::string unit = {};
};

const std::string spacings = " spacings";

/** Collects the settings of one peer after the other. */
class SettingList
{
public:
  void
  begin (const std::string& peer)
  {
    peer_ = peer;
  }

  void
  add (const std::vector<Value>& values, bool is_default = false)
  {
    PeerSetting setting;
    setting.peer = peer_;
    setting.is_default = is_default;
    std::ostringstream text;
    for (const Value& value : values) {
      text << (setting.values.empty () ? "" : ", ") << value.name << ' ' << value.value << value.unit;
      setting.values[value.name] = value.value;
    }
    setting.parameters = text.str ();
    settings.push_back (setting);
  }

  void
  addDefault (const std::vector<Value>& values)
  {
    add (values, true);
  }

  std::vector<PeerSetting> settings;

private:
  std::string peer_;
};

/** MeshLab's defaults, and what the paper's Table I lists. */
void
addMeshLab (SettingList& list)
{
  list.begin ("APSS");
  list.addDefault ({{"filter scale", 2}, {"spherical parameter", 1}});
  for (const auto& [scale, spherical] :
       {std::pair {2., .5}, {3., .5}, {3., .75}, {3., 1.}, {4., .5}, {4., .75}, {4., 1.}})
    list.add ({{"filter scale", scale}, {"spherical parameter", spherical}});

  list.begin ("RIMLS");
  list.addDefault ({{"filter scale", 2}, {"sharpness", .75}});
  for (const auto& [scale, sharpness] : {std::pair {3., .5}, {3., .75}, {4., .5}, {4., .75}, {4., 1.}, {5., .5}})
    list.add ({{"filter scale", scale}, {"sharpness", sharpness}});
}

void
addProjections (SettingList& list)
{
  list.begin ("LOP");
  list.addDefault ({{"h", 4, spacings}, {"mu", .25}, {"iterations", 10}});
  for (const auto& [h, mu] : {std::pair {3., .1}, {4., .4}, {6., .25}})
    list.add ({{"h", h, spacings}, {"mu", mu}, {"iterations", 10}});

  list.begin ("WLOP");
  list.addDefault ({{"radius", 8, spacings}, {"iterations", 35}, {"uniform", 0}});
  for (const double radius : {2., 3., 4.})
    list.add ({{"radius", radius, spacings}, {"iterations", 10}, {"uniform", 0}});
}

void
addFits (SettingList& list)
{
  list.begin ("CGAL jet");
  for (const double neighbors : {12, 18, 24, 32, 48})
    list.add ({{"neighbors", neighbors}}, neighbors == 24);

  list.begin ("CGAL bilateral");
  list.addDefault ({{"neighbors", 120}, {"sharpness angle", 25}, {"iterations", 2}});
  for (const double neighbors : {12, 24})
    list.add ({{"neighbors", neighbors}, {"sharpness angle", 30}, {"iterations", 1}});

  list.begin ("PCL MLS");
  list.add ({{"order", 1}, {"radius", 1.5, spacings}});
  list.add ({{"order", 1}, {"radius", 2, spacings}});
  list.add ({{"order", 2}, {"radius", 2.5, spacings}});
  list.add ({{"order", 2}, {"radius", 3, spacings}});
  list.addDefault ({{"order", 2}, {"radius", 4, spacings}});
}
} // namespace

std::vector<PeerSetting>
peerSettings ()
{
  SettingList list;
  addMeshLab (list);
  addProjections (list);
  addFits (list);
  return list.settings;
}

} // namespace pcl_normal_smoothing::evaluation
