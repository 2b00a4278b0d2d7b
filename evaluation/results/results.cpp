// SPDX-License-Identifier: BSD-3-Clause
#include "results/results.h"

#include "command_line/tool.h"
#include "files/cloud_io.h"
#include "files/output_file.h"
#include "files/tool_error.h"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr auto between_saves = std::chrono::seconds (3);
} // namespace

Results::Results (const std::string& folder) : folder_ (folder), lock_ (folder)
{
  if (std::filesystem::exists (folder_ + "/rows.json"))
    load ();
}

void
Results::load ()
{
  const std::string path = folder_ + "/rows.json";
  try {
    const Json all = Json::parse (tools::readFile (path));
    for (const Json& json : all) {
      const Row row = fromJson (json);
      places_[row.key ()] = rows_.size ();
      rows_.push_back (row);
    }
  }
  catch (const Json::exception& error) {
    throw tools::FileError (path, std::string ("is not what a study writes (") + error.what () + ")",
                            "remove it, or give another folder");
  }
}

const Row*
Results::find (const std::string& key) const
{
  const auto found = places_.find (key);
  return found == places_.end () ? nullptr : &rows_[found->second];
}

bool
Results::answered (const std::string& key) const
{
  const Row* row = find (key);
  return row && row->ok ();
}

void
Results::put (const Row& row)
{
  const auto [place, added] = places_.try_emplace (row.key (), rows_.size ());
  if (added)
    rows_.push_back (row);
  else
    rows_[place->second] = row;
  if (std::chrono::steady_clock::now () - saved_ < between_saves)
    return;
  try {
    save ();
    said_ = false;
  }
  catch (const tools::FileError& error) { // there may be space on the disk again before the study ends
    if (!said_)
      tools::note (std::string (error.what ()) + "; going on, and trying again");
    said_ = true;
    saved_ = std::chrono::steady_clock::now ();
  }
}

void
Results::save ()
{
  tools::OutputFile csv (folder_ + "/rows.csv");
  csv.write (csvHeader () + "\r\n");
  for (const Row& row : rows_)
    csv.write (toCsv (row) + "\r\n");
  csv.commit ();
  tools::OutputFile json (folder_ + "/rows.json");
  const char* separator = "[\n";
  for (const Row& row : rows_) {
    json.write (separator + toJson (row).dump (-1, ' ', false, Json::error_handler_t::replace));
    separator = ",\n";
  }
  json.write (rows_.empty () ? "[]\n" : "\n]\n");
  json.commit ();
  saved_ = std::chrono::steady_clock::now ();
}

} // namespace pcl_normal_smoothing::evaluation
