// SPDX-License-Identifier: BSD-3-Clause
#include "results/study_file.h"

#include "command_line/options.h"
#include "files/checksum.h"
#include "files/cloud_io.h"
#include "files/output_file.h"
#include "files/tool_error.h"
#include "meshes/mesh_measures.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Json = nlohmann::ordered_json;

const char* const advice = "give another folder, or remove this one";

/** Checksum of the bits of the vertices' coordinates and of the triangles' indices. */
std::string
fingerprint (const tools::Mesh& mesh)
{
  tools::Checksum checksum;
  const auto add = [&] (const auto& numbers) {
    checksum.add ({reinterpret_cast<const char*> (numbers.data ()), numbers.size () * sizeof numbers[0]});
  };
  add (mesh.vertices);
  add (mesh.triangles);
  return checksum.text ();
}

Json
describe (const Model& model)
{
  return {{"name", model.name},
          {"file", "models/" + model.name + ".ply"},
          {"points", model.mesh.vertices.size ()},
          {"triangles", model.mesh.triangles.size ()},
          {"mean_edge", tools::meanEdgeLength (model.mesh)},
          {"source", model.source},
          {"exact_surface", static_cast<bool> (model.surface_distance)},
          {"fingerprint", fingerprint (model.mesh)}};
}

/** The earlier study of the folder; empty if there is none. */
Json
readEarlier (const std::string& path)
{
  if (!std::filesystem::exists (path))
    return Json::object ();
  try {
    const Json earlier = Json::parse (tools::readFile (path));
    if (earlier.at ("version") != tools::version ())
      throw tools::FileError (path,
                              "is by version " + earlier.at ("version").get<std::string> () + ", this is " +
                                  tools::version (),
                              advice);
    return earlier;
  }
  catch (const Json::exception& error) {
    throw tools::FileError (path, std::string ("is not what a study writes (") + error.what () + ")", advice);
  }
}

/** The earlier values, followed by the new ones. */
template <typename T>
Json
united (const Json& earlier, const char* name, const std::vector<T>& now)
{
  auto all = earlier.value (name, Json::array ());
  for (const Json value : now)
    if (std::find (all.begin (), all.end (), value) == all.end ())
      all.push_back (value);
  return all;
}
} // namespace

void
writeStudyFile (const std::string& folder, const StudyFile& study, const std::vector<Model>& models)
{
  const std::string path = folder + "/study.json";
  const Json earlier = readEarlier (path);
  Json listed = earlier.value ("models", Json::array ());
  for (const Model& model : models) {
    const Json description = describe (model);
    const auto same_name = std::find_if (listed.begin (), listed.end (),
                                         [&] (const Json& m) { return m.value ("name", "") == model.name; });
    if (same_name == listed.end ())
      listed.push_back (description);
    else if (same_name->value ("fingerprint", "") == description.at ("fingerprint"))
      *same_name = description;
    else
      throw tools::FileError (path, "has results of another model " + model.name, advice);
  }
  const Json all {{"version", tools::version ()},
                  {"command_line", study.command_line},
                  {"models", listed},
                  {"noises", united (earlier, "noises", study.noises)},
                  {"sigmas", united (earlier, "sigmas", study.sigmas)},
                  {"seeds", united (earlier, "seeds", study.seeds)},
                  {"sharp_edge_degrees", 30},
                  {"lengths", "mean edge lengths of the clean mesh"}};
  tools::OutputFile output (path);
  output.write (all.dump (2, ' ', false, Json::error_handler_t::replace) + "\n");
  output.commit ();
}

} // namespace pcl_normal_smoothing::evaluation
