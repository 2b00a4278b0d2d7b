// SPDX-License-Identifier: BSD-3-Clause
#include "tool_runner.h"

#include "files/field_values.h"

#include <pcl_normal_smoothing/vector_layout.h>

#include <pcl/common/io.h>
#include <pcl/io/pcd_io.h>

#include <fcntl.h>
#include <spawn.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace fs = std::filesystem;
using namespace pcl_normal_smoothing;
using Field = pcl::PCLPointField;

extern char** environ;

namespace
{
test_support::ChildProcess
spawned (const std::vector<std::string>& words, const std::string& folder)
{
  std::vector<char*> arguments;
  for (const std::string& word : words)
    arguments.push_back (const_cast<char*> (word.c_str ()));
  arguments.push_back (nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init (&actions);
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen (&actions, 1, (folder + "/stdout").c_str (), flags, 0600);
  posix_spawn_file_actions_addopen (&actions, 2, (folder + "/stderr").c_str (), flags, 0600);
  pid_t process = 0;
  const int error = posix_spawn (&process, words[0].c_str (), &actions, nullptr, arguments.data (), environ);
  posix_spawn_file_actions_destroy (&actions);
  if (error != 0)
    throw std::runtime_error (words[0] + " cannot be started (" + std::strerror (error) + ")");
  return test_support::ChildProcess (process);
}
} // namespace

RunningTool::RunningTool (const std::vector<std::string>& words, std::string folder)
: process_ (spawned (words, folder)), folder_ (std::move (folder))
{}

Ending
RunningTool::wait ()
{
  Ending run;
  run.status = process_.wait ();
  run.out = contentOf (folder_ + "/stdout");
  run.err = contentOf (folder_ + "/stderr");
  return run;
}

ToolTest::ToolTest (std::string tools) : tools_ (std::move (tools))
{
  std::signal (SIGINT, SIG_DFL); // background jobs inherit that it is ignored, and so would the tools
  folder_ = (fs::temp_directory_path () / "test_tools.XXXXXX").string ();
  if (!mkdtemp (folder_.data ()))
    throw std::runtime_error (folder_ + " cannot be made (" + std::strerror (errno) + ")");
}

ToolTest::~ToolTest ()
{
  fs::remove_all (folder_);
}

Ending
ToolTest::run (const std::string& command) const
{
  std::istringstream stream (command);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    const bool file =
        !words.empty () && word[0] != '-' && word.find ('.') != std::string::npos && std::isalpha (word[0]);
    words.push_back (words.empty () ? tools_ + "/" + word : file ? path (word) : word);
  }
  return RunningTool (words, folder_).wait ();
}

Ending
ToolTest::succeed (const std::string& command) const
{
  const Ending result = run (command);
  EXPECT_EQ (result.status, 0) << command << "\n" << result.err;
  return result;
}

std::set<std::string>
ToolTest::files () const
{
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator (folder_))
    names.insert (entry.path ().filename ().string ());
  names.erase ("stdout");
  names.erase ("stderr");
  return names;
}

std::string
contentOf (const std::string& path)
{
  std::ifstream file (path, std::ios::binary);
  return {std::istreambuf_iterator<char> (file), {}};
}

void
writeText (const std::string& path, const std::string& text)
{
  std::ofstream (path, std::ios::binary) << text;
}

namespace
{
void
addField (pcl::PCLPointCloud2& cloud, const std::string& name, std::uint8_t datatype, unsigned count = 1)
{
  Field field;
  field.name = name;
  field.offset = cloud.point_step;
  field.datatype = datatype;
  field.count = count;
  cloud.fields.push_back (field);
  cloud.point_step += static_cast<unsigned> (pcl::getFieldSize (datatype)) * count;
}

/** Fills with bytes that look random and form finite floats and doubles. */
void
fillWithPattern (std::vector<std::uint8_t>& data)
{
  std::uint32_t state = 1;
  for (std::uint8_t& byte : data)
    byte = static_cast<std::uint8_t> ((state = state * 1664525u + 1013904223u) >> 25); // below 128
}
} // namespace

tools::CloudFile
makeWave (std::uint8_t position_type, const Eigen::Vector3d& origin)
{
  tools::CloudFile file;
  file.cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
  pcl::PCLPointCloud2& cloud = *file.cloud;
  addField (cloud, "intensity", Field::FLOAT32);
  for (const char* name : {"x", "y", "z"})
    addField (cloud, name, position_type);
  addField (cloud, "rgba", Field::UINT32);
  addField (cloud, "label", Field::UINT16);
  addField (cloud, "quality", Field::INT8);
  addField (cloud, "histogram", Field::FLOAT32, 3);
  addField (cloud, "stamp", Field::FLOAT64);
  cloud.width = 20;
  cloud.height = 15;
  cloud.row_step = cloud.width * cloud.point_step;
  cloud.data.resize (cloud.height * cloud.row_step);
  fillWithPattern (cloud.data);
  const VectorLayout layout = *VectorLayout::find (cloud, {"x", "y", "z"});
  for (std::size_t i = 0; i < file.size (); ++i) {
    // Multiples of 1 / 1024, which float represents exactly, even far from the origin.
    const double x = double (i % 20) / 4, y = double (i / 20) / 4, z = std::sin (x) / 2 + double (i * 7919 % 13) / 200;
    const Eigen::Vector3d rounded = (Eigen::Vector3d (x, y, z) * 1024).array ().round () / 1024;
    layout.set (cloud.data.data (), i, rounded + origin);
  }
  const double nan = std::numeric_limits<double>::quiet_NaN ();
  for (const std::size_t i : {7u, 100u})
    layout.set (cloud.data.data (), i, {nan, nan, nan});
  file.origin = Eigen::Vector4f (0.1f, -2.5f, 33.3333f, 0);
  file.orientation = Eigen::Quaternionf (0.1f, 0.2f, 0.3f, 0.4f).normalized ();
  return file;
}

void
savePcd (const tools::CloudFile& file, const std::string& path, bool binary)
{
  pcl::PCDWriter writer;
  if (binary)
    writer.writeBinary (path, *file.cloud, file.origin, file.orientation);
  else
    writer.writeASCII (path, *file.cloud, file.origin, file.orientation, 17);
}

tools::CloudFile
readPcdFile (const std::string& path)
{
  tools::CloudFile file;
  file.cloud = pcl::make_shared<pcl::PCLPointCloud2> ();
  int version;
  EXPECT_EQ (pcl::PCDReader ().read (path, *file.cloud, file.origin, file.orientation, version), 0) << path;
  return file;
}

Eigen::Vector3d
positionOf (const tools::CloudFile& file, std::size_t i)
{
  return VectorLayout::find (*file.cloud, {"x", "y", "z"})->get (file.cloud->data.data (), i);
}

std::string
bytesOf (const tools::CloudFile& file, const std::string& name)
{
  const Field* field = tools::findField (*file.cloud, name);
  std::string bytes;
  if (!field) {
    ADD_FAILURE () << "no field " << name;
    return bytes;
  }
  const std::size_t size = tools::sizeOfType (field->datatype) * field->count;
  for (std::size_t i = 0; i < file.size (); ++i)
    bytes.append (reinterpret_cast<const char*> (&file.cloud->data[i * file.cloud->point_step + field->offset]), size);
  return bytes;
}
