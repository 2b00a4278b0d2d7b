// SPDX-License-Identifier: BSD-3-Clause
#include "meshlab.h"

#include "clouds/cloud_graph.h"
#include "files/field_values.h"
#include "point_file.h"

#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
const char* const input_name = "noisy.ply";
const char* const output_name = "smooth.ply";
const char* const script_name = "filters.mlx";

/** Computes the normals that the projections need. All values are MeshLab's defaults; a script must list them all. */
const char* const normals_filter = R"( <filter name="Compute normals for point sets">
  <Param type="RichInt" name="K" value="10"/>
  <Param type="RichInt" name="smoothIter" value="0"/>
  <Param type="RichBool" name="flipFlag" value="false"/>
  <Param type="RichPoint3f" name="viewPos" x="0" y="0" z="0"/>
 </filter>
)";

/** Parameters of both projections, at MeshLab's defaults. The cloud is projected onto the surface that it defines. */
const char* const common_parameters = R"(  <Param type="RichMesh" name="ControlMesh" value="0"/>
  <Param type="RichMesh" name="ProxyMesh" value="0"/>
  <Param type="RichBool" name="SelectionOnly" value="false"/>
  <Param type="RichFloat" name="ProjectionAccuracy" value="0.0001"/>
  <Param type="RichInt" name="MaxProjectionIters" value="15"/>
  <Param type="RichInt" name="MaxSubdivisions" value="0"/>
  <Param type="RichFloat" name="ThAngleInDegree" value="2"/>
)";

std::string
floatParameter (const std::string& name, double value)
{
  std::ostringstream text;
  text << "  <Param type=\"RichFloat\" name=\"" << name << "\" value=\"" << value << "\"/>\n";
  return text.str ();
}

std::string
filterScript (const PeerSetting& setting)
{
  std::string script = "<!DOCTYPE FilterScript>\n<FilterScript>\n" + std::string (normals_filter);
  script += " <filter name=\"MLS projection (" + setting.peer + ")\">\n" + common_parameters;
  script += floatParameter ("FilterScale", setting.values.at ("filter scale"));
  if (setting.peer == "APSS") {
    script += floatParameter ("SphericalParameter", setting.values.at ("spherical parameter"));
    script += "  <Param type=\"RichBool\" name=\"AccurateNormal\" value=\"true\"/>\n";
  }
  else {
    script += floatParameter ("SigmaN", setting.values.at ("sharpness"));
    script += "  <Param type=\"RichInt\" name=\"MaxRefittingIters\" value=\"3\"/>\n";
  }
  return script + " </filter>\n</FilterScript>\n";
}
} // namespace

void
writeMeshLabInput (const WorkFolder& folder, const PeerSetting& setting, const std::vector<Eigen::Vector3d>& points)
{
  std::string ply = "ply\nformat ascii 1.0\nelement vertex " + std::to_string (points.size ()) +
                    "\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  for (const auto& point : points) {
    for (const double coordinate : point) {
      tools::appendFloat (static_cast<float> (coordinate), ply);
      ply += ' ';
    }
    ply += '\n';
  }
  writeBytes (folder.file (input_name), ply);
  writeBytes (folder.file (script_name), filterScript (setting));
}

std::vector<std::string>
meshLabCommand (const WorkFolder& folder, const std::string& meshlabserver)
{
  // It opens no window, but does not start without an X display.
  return {"xvfb-run",
          "-a",
          meshlabserver,
          "-i",
          folder.file (input_name),
          "-o",
          folder.file (output_name),
          "-s",
          folder.file (script_name)};
}

std::vector<Eigen::Vector3d>
readMeshLabOutput (const WorkFolder& folder)
{
  const std::string path = folder.file (output_name);
  // It exits with status 0 even if it could not read a file.
  if (!std::filesystem::exists (path))
    throw std::runtime_error ("MeshLab wrote no result");
  const tools::CloudFile file = tools::loadCloud (path);
  const VectorView positions = tools::positionsOf (file);
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < positions.size; ++i)
    points.push_back (positions.layout.get (positions.data, i));
  return points;
}

} // namespace pcl_normal_smoothing::evaluation
