// SPDX-License-Identifier: BSD-3-Clause
#include "peer.h"

#include <sstream>
#include <utility>

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

using Pair = std::pair<double, double>;

const std::string spacings = " spacings";

/** Collects the settings, peer by peer. */
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

/** MeshLab's defaults, the values in the paper's Table I, and those with the lowest measured error. */
void
addMeshLab (SettingList& list)
{
  list.begin ("APSS");
  list.addDefault ({{"filter scale", 2}, {"spherical parameter", 1}});
  for (const auto& [scale, spherical] : {Pair {2, .5}, {3, .5}, {3, .75}, {3, 1}, {4, .5}, {4, .75}, {4, 1}})
    list.add ({{"filter scale", scale}, {"spherical parameter", spherical}});

  list.begin ("RIMLS");
  list.addDefault ({{"filter scale", 2}, {"sharpness", .75}});
  for (const auto& [scale, sharpness] :
       {Pair {3, .25}, {3, .5}, {3, .75}, {4, .5}, {4, .75}, {4, 1}, {5, .25}, {5, .5}})
    list.add ({{"filter scale", scale}, {"sharpness", sharpness}});
}

/** Table I gives h in an unstated unit: about 6 to 9 spacings if it is the diagonal. */
void
addLop (SettingList& list)
{
  // No program sets a default: we take the mean of the paper's mu, and the lower end of its h.
  list.begin ("LOP");
  for (const auto& [h, mu] : {Pair {4, .3}, {6, .1}, {6, .3}, {8, .3}})
    list.add ({{"h", h, spacings}, {"mu", mu}, {"iterations", 10}}, h == 6 && mu == .3);
}

/** CGAL's defaults, or the values in its examples where it has none. */
void
addCgal (SettingList& list)
{
  list.begin ("WLOP");
  list.addDefault ({{"radius", 8, spacings}, {"iterations", 35}, {"uniform", 0}});
  list.add ({{"radius", 3, spacings}, {"iterations", 10}, {"uniform", 0}});
  for (const double radius : {2.5, 3.})
    list.add ({{"radius", radius, spacings}, {"iterations", 10}, {"uniform", 1}});

  list.begin ("CGAL jet");
  for (const double neighbors : {12, 18, 24, 32, 48})
    list.add ({{"neighbors", neighbors}}, neighbors == 24);

  list.begin ("CGAL bilateral");
  list.addDefault ({{"neighbors", 120}, {"sharpness angle", 25}, {"iterations", 2}});
  for (const auto& [neighbors, angle] : {Pair {16, 30}, {24, 15}, {24, 30}, {30, 30}})
    list.add ({{"neighbors", neighbors}, {"sharpness angle", angle}, {"iterations", 1}});
}

/** PCL's default order. It has no default radius; that of its tutorial is 3.4 spacings of the tutorial's cloud. */
void
addPcl (SettingList& list)
{
  list.begin ("PCL MLS");
  for (const auto& [order, radius] : {Pair {1, 1.5}, {1, 2}, {2, 2.5}, {2, 3}, {2, 3.4}, {2, 4}})
    list.add ({{"order", order}, {"radius", radius, spacings}}, radius == 3.4);
}
} // namespace

std::vector<PeerSetting>
peerSettings ()
{
  SettingList list;
  addMeshLab (list);
  addLop (list);
  addCgal (list);
  addPcl (list);
  return list.settings;
}

} // namespace pcl_normal_smoothing::evaluation
