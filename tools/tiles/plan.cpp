// SPDX-License-Identifier: BSD-3-Clause
#include "plan.h"

#include "command_line/options.h"
#include "files/checksum.h"
#include "files/tool_error.h"
#include "plan_options.h"

#include <cstdio>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
constexpr int format_version = 3;
constexpr const char* plan_again = "run plan again";

std::string
tilePath (const std::string& folder, std::size_t tile, const char* kind)
{
  char name[40];
  std::snprintf (name, sizeof name, "/tile_%06zu.%s", tile, kind);
  return folder + name;
}

Json
shapeAsJson (const CloudShape& shape)
{
  Json fields = Json::array ();
  for (const auto& field : shape.fields)
    fields.push_back (
        {{"name", field.name}, {"offset", field.offset}, {"datatype", field.datatype}, {"count", field.count}});
  const auto& o = shape.origin;
  const auto& q = shape.orientation;
  return {{"width", shape.width},
          {"height", shape.height},
          {"point_step", shape.point_step},
          {"origin", {o[0], o[1], o[2], o[3]}},
          {"orientation", {q.w (), q.x (), q.y (), q.z ()}},
          {"fields", fields}};
}

CloudShape
shapeFromJson (const Json& json)
{
  CloudShape shape;
  shape.width = json.at ("width");
  shape.height = json.at ("height");
  shape.point_step = json.at ("point_step");
  for (int d = 0; d < 4; ++d)
    shape.origin[d] = json.at ("origin").at (static_cast<std::size_t> (d));
  const Json& q = json.at ("orientation");
  shape.orientation = Eigen::Quaternionf (q.at (0), q.at (1), q.at (2), q.at (3));
  for (const Json& field : json.at ("fields")) {
    shape.fields.emplace_back ();
    shape.fields.back ().name = field.at ("name");
    shape.fields.back ().offset = field.at ("offset");
    shape.fields.back ().datatype = field.at ("datatype");
    shape.fields.back ().count = field.at ("count");
  }
  return shape;
}

Json
recordAsJson (const RecordLayout& record)
{
  return {{"position_bytes", record.positionBytes ()}, {"normal_bytes", record.normalBytes ()}};
}

RecordLayout
recordFromJson (const Json& json)
{
  return RecordLayout (json.at ("position_bytes"), json.at ("normal_bytes"));
}

Json
asJson (const Plan& plan)
{
  Json sources = Json::array (), tiles = Json::array ();
  for (const Source& source : plan.sources)
    sources.push_back ({{"path", source.path},
                        {"first", source.first},
                        {"bytes", source.bytes},
                        {"changed", source.changed},
                        {"checksum", source.checksum},
                        {"cloud", shapeAsJson (source.shape)}});
  for (const Tile& tile : plan.tiles)
    tiles.push_back ({{"points", tile.points}, {"first_cell", tile.first_cell}, {"cells", tile.cells}});
  return {{"format", format_version},
          {"version", version ()},
          {"request", plan.request},
          {"points", plan.points},
          {"parameters", plan.parameters},
          {"unit", plan.unit},
          {"separate_sheets", plan.separate},
          {"save_normals", plan.save_normals},
          {"neighbors", queryAsJson (plan.query)},
          {"options", optionsAsJson (plan.options)},
          {"record", recordAsJson (plan.record)},
          {"result", recordAsJson (plan.result)},
          {"cells", plan.cells.size ()},
          {"sources", sources},
          {"tiles", tiles}};
}

Plan
fromJson (const Json& json)
{
  Plan plan;
  plan.request = json.at ("request");
  plan.points = json.at ("points");
  plan.parameters = json.at ("parameters");
  plan.unit = json.at ("unit");
  plan.separate = json.at ("separate_sheets");
  plan.save_normals = json.at ("save_normals");
  plan.query = queryFromJson (json.at ("neighbors"));
  plan.options = optionsFromJson (json.at ("options"));
  plan.record = recordFromJson (json.at ("record"));
  plan.result = recordFromJson (json.at ("result"));
  for (const Json& source : json.at ("sources"))
    plan.sources.push_back ({source.at ("path"), shapeFromJson (source.at ("cloud")), source.at ("first"),
                             source.at ("bytes"), source.at ("changed"), source.at ("checksum")});
  for (const Json& tile : json.at ("tiles"))
    plan.tiles.push_back ({tile.at ("points"), tile.at ("first_cell"), tile.at ("cells")});
  plan.cells.resize (json.at ("cells"));
  plan.id = json.at ("id");
  return plan;
}

static_assert (sizeof (Cell) == 80, "cells are written as they lie in memory");

std::string_view
bytesOf (const std::vector<Cell>& cells)
{
  return {reinterpret_cast<const char*> (cells.data ()), cells.size () * sizeof (Cell)};
}

/** A checksum of the plan's text without the id, and of its cells. */
std::string
idOf (Json json, const std::vector<Cell>& cells)
{
  json.erase ("id");
  Checksum checksum;
  checksum.add (json.dump ());
  checksum.add (bytesOf (cells));
  return checksum.text ();
}

std::string
planPath (const std::string& folder)
{
  return folder + "/plan.json";
}

std::string
cellsPath (const std::string& folder)
{
  return folder + "/cells.bin";
}
} // namespace

std::string
Plan::pointsPath (std::size_t tile) const
{
  return tilePath (folder, tile, "points");
}

std::string
Plan::resultPath (std::size_t tile) const
{
  return tilePath (folder, tile, "result");
}

void
savePlan (Plan& plan)
{
  OutputFile cells (cellsPath (plan.folder));
  cells.write (bytesOf (plan.cells));
  cells.commit ();
  Json json = asJson (plan);
  plan.id = idOf (json, plan.cells);
  json["id"] = plan.id;
  OutputFile file (planPath (plan.folder));
  file.write (json.dump (1) + "\n");
  file.commit ();
}

Plan
loadPlan (const std::string& folder)
{
  const std::string path = planPath (folder);
  if (std::error_code error; !std::filesystem::exists (path, error))
    throw FileError (folder, "holds no plan", "make one: pcl_normal_smoothing_tiles plan " + folder + " input...");
  try {
    const Json json = Json::parse (readFile (path));
    if (json.at ("format") != format_version || json.at ("version") != version ())
      throw FileError (path, "is of another version of this tool", plan_again);
    Plan plan = fromJson (json);
    plan.folder = folder;
    const std::string cells = readFile (cellsPath (folder));
    if (cells.size () != plan.cells.size () * sizeof (Cell))
      throw FileError (cellsPath (folder), "does not go with the plan", plan_again);
    std::memcpy (static_cast<void*> (plan.cells.data ()), cells.data (), cells.size ());
    if (idOf (json, plan.cells) != plan.id)
      throw FileError (path, "is damaged, it or cells.bin, its checksum differs", plan_again);
    return plan;
  }
  catch (const Json::exception& error) {
    throw FileError (path, std::string ("is no plan, or is damaged (") + error.what () + ")", plan_again);
  }
}

CloudFile
emptyCloud (const CloudShape& shape)
{
  CloudFile file;
  file.cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
  CloudShape without_points = shape;
  without_points.width = 0;
  setShape (without_points, file);
  return file;
}
} // namespace tools
} // namespace pcl_normal_smoothing
