// SPDX-License-Identifier: BSD-3-Clause
#include "tool_runner.h"

#include <sys/stat.h>

#include <cstring>
#include <filesystem>
#include <thread>

namespace fs = std::filesystem;
using namespace pcl_normal_smoothing;

namespace
{
class FileTrouble : public ToolTest
{
protected:
  void
  SetUp () override
  {
    savePcd (makeWave (), path ("wave.pcd"));
  }

  /** Expects status 2, a message that names the file and contains \a word, and no new file. */
  void
  expectRefused (const std::string& command, const std::string& file, const std::string& word)
  {
    const std::set<std::string> before = files ();
    const Ending result = run (command);
    EXPECT_EQ (result.status, 2) << command << "\n" << result.err;
    EXPECT_NE (result.err.find (file + ": "), std::string::npos) << command << "\n" << result.err;
    EXPECT_NE (result.err.find (word), std::string::npos) << command << "\n" << result.err;
    EXPECT_EQ (files (), before) << command;
  }

  void
  expectUnreadable (const std::string& name, const std::string& content, const std::string& word)
  {
    writeText (path (name), content);
    expectRefused ("pcl_normal_smoothing " + name + " out.pcd", path (name), word);
  }
};

/** A PCD header that claims to have \a points points. */
std::string
pcd (const std::string& points, const std::string& data)
{
  return "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH " + points + "\nHEIGHT 1\nPOINTS " +
         points + "\nDATA " + data;
}

std::string
ply (const std::string& format, const std::string& rest)
{
  return "ply\nformat " + format + " 1.0\n" + rest;
}

constexpr const char* xyz = "property float x\nproperty float y\nproperty float z\nend_header\n";
} // namespace

TEST_F (FileTrouble, Input)
{
  expectRefused ("pcl_normal_smoothing none.pcd out.pcd", path ("none.pcd"), "No such file");
  fs::create_directory (path ("folder.pcd"));
  expectRefused ("pcl_normal_smoothing folder.pcd out.pcd", path ("folder.pcd"), "folder");
  expectUnreadable ("cloud.xyz", "1 2 3\n", "extension");
  expectUnreadable ("mesh.off", "OFF\n1 0 0\n0 0 0\n", "is a mesh");
  expectRefused ("pcl_normal_smoothing - out.pcd", "-", "named pipe");
  expectUnreadable ("empty.pcd", "", "FIELDS");
  expectUnreadable ("empty.ply", "", "ply");
  expectUnreadable ("noise.pcd", std::string (100000, 'x'), "FIELDS");
  expectUnreadable ("other.ply", "OFF\n1 2 3\n", "ply");
}

TEST_F (FileTrouble, PcdThatLies)
{
  expectUnreadable ("a.pcd", pcd ("2000000000", "binary\n123"), "truncated");
  expectUnreadable ("a.pcd", pcd ("2000000000", "ascii\n1 2 3\n"), "truncated");
  expectUnreadable ("a.pcd", pcd ("99999999999999999999", "ascii\n"), "WIDTH");
  expectUnreadable ("a.pcd", pcd ("-5", "ascii\n"), "WIDTH");
  expectUnreadable ("a.pcd", pcd ("4000000000", "binary\n"), "more points");
  expectUnreadable ("a.pcd", pcd ("2", "ascii\n1 2 3\n"), "truncated");
  expectUnreadable ("a.pcd", pcd ("2", "ascii\n1.25 2.25 3.25\n4 5\n"), "point 1 is missing");
  expectUnreadable ("a.pcd", pcd ("1", "ascii\n1 2 three\n"), "three");
  expectUnreadable ("a.pcd", pcd ("1", "ascii\n1 2 3 4\n"), "more values");
  expectUnreadable ("a.pcd", pcd ("1", "base64\nAAAA\n"), "DATA");
  std::string sizes (8, '\0'); // compressed and uncompressed size
  expectUnreadable ("a.pcd", pcd ("1000", "binary_compressed\n"), "truncated");
  expectUnreadable ("a.pcd", pcd ("1000", "binary_compressed\n" + sizes), "claims");
  const std::uint32_t lie[2] = {100, 12000};
  std::memcpy (sizes.data (), lie, sizeof lie);
  expectUnreadable ("a.pcd", pcd ("1000", "binary_compressed\n" + sizes + std::string (99, '\x40')), "claims");
  expectUnreadable ("a.pcd", "FIELDS x y z\nSIZE 3 4 4\nTYPE F F F\nPOINTS 0\nDATA ascii\n", "type");
  expectUnreadable ("a.pcd", "FIELDS x y z\nSIZE 4 4\nTYPE F F F\nPOINTS 0\nDATA ascii\n", "SIZE");
  expectUnreadable ("a.pcd", "FIELDS x\nSIZE 4\nTYPE F\nCOUNT 4000000000\nPOINTS 1\nDATA binary\n", "COUNT");
  expectUnreadable ("a.pcd", "FIELDS x\nSIZE 4\nTYPE F\nWIDTH 3\nHEIGHT 3\nPOINTS 8\nDATA ascii\n", "POINTS");
}

TEST_F (FileTrouble, PlyThatLies)
{
  const std::string huge = std::string ("element vertex 2000000000\n") + xyz;
  for (const std::string format : {"ascii", "binary_little_endian", "binary_big_endian"})
    expectUnreadable ("a.ply", ply (format, huge + "1 2 3\n"), "truncated");
  expectUnreadable ("a.ply", ply ("ascii", std::string ("element vertex 2\n") + xyz + "1 2 3\n"), "truncated");
  expectUnreadable ("a.ply", ply ("ascii", std::string ("element vertex 1\n") + xyz + "1 2 three\n"), "three");
  expectUnreadable ("a.ply", ply ("ascii", "element vertex 1\nproperty list uchar float x\nend_header\n200 1 2\n"),
                    "truncated");
  expectUnreadable ("a.ply", ply ("ascii", "element vertex 2\nproperty list uchar float h\nend_header\n2 1 2\n1 1\n"),
                    "different lengths");
  expectUnreadable ("a.ply", ply ("xml", std::string ("element vertex 1\n") + xyz), "format");
  expectUnreadable ("a.ply", ply ("ascii", "element vertex 1\nproperty quad x\nend_header\n"), "type");
  expectUnreadable ("a.ply", ply ("ascii", "element face 1\nproperty float x\nend_header\n1\n"), "vertex");
  expectUnreadable ("a.ply", ply ("ascii", "element vertex 1\nproperty float x\n"), "end");
}

TEST_F (FileTrouble, Output)
{
  expectRefused ("pcl_normal_smoothing wave.pcd none/out.pcd", path ("none/out.pcd"), "folder");
  fs::create_directory (path ("folder.pcd"));
  expectRefused ("pcl_normal_smoothing wave.pcd folder.pcd", path ("folder.pcd"), "folder");
  fs::create_symlink ("/dev/full", path ("full.pcd"));
  expectRefused ("pcl_normal_smoothing wave.pcd full.pcd", path ("full.pcd"), "No space left");
}

TEST_F (FileTrouble, FullDiskLeavesTheOldFile)
{
  writeText (path ("out.pcd"), "precious");
  const std::set<std::string> before = files ();
  const std::string command = "ulimit -f 8; exec " TOOLS_FOLDER "/pcl_normal_smoothing " + path ("wave.pcd") + " " +
                              path ("out.pcd") + " -format ascii";
  const Ending result = RunningTool ({"/bin/sh", "-c", command}, folder_).wait ();
  EXPECT_EQ (result.status, 2) << result.err;
  EXPECT_NE (result.err.find (path ("out.pcd") + ": "), std::string::npos) << result.err;
  EXPECT_EQ (contentOf (path ("out.pcd")), "precious");
  EXPECT_EQ (files (), before);
}

TEST_F (FileTrouble, InputIsOutput)
{
  succeed ("pcl_normal_smoothing wave.pcd out.pcd");
  succeed ("pcl_normal_smoothing wave.pcd wave.pcd");
  EXPECT_EQ (contentOf (path ("wave.pcd")), contentOf (path ("out.pcd")));
  EXPECT_EQ (files (), (std::set<std::string> {"out.pcd", "wave.pcd"}));
}

TEST_F (FileTrouble, LinksAndRightsStay)
{
  writeText (path ("real.pcd"), "old");
  chmod (path ("real.pcd").c_str (), 0640);
  fs::create_symlink ("real.pcd", path ("link.pcd"));
  const std::string input = contentOf (path ("wave.pcd"));
  succeed ("pcl_normal_smoothing wave.pcd link.pcd");
  EXPECT_TRUE (fs::is_symlink (path ("link.pcd")));
  EXPECT_GT (fs::file_size (path ("real.pcd")), 1000u);
  EXPECT_EQ (static_cast<unsigned> (fs::status (path ("real.pcd")).permissions ()), 0640u);
  EXPECT_EQ (contentOf (path ("wave.pcd")), input);
}

TEST_F (FileTrouble, Pipes)
{
  succeed ("pcl_normal_smoothing wave.pcd out.pcd");
  for (const char* name : {"in_pipe.pcd", "out_pipe.pcd"})
    ASSERT_EQ (mkfifo (path (name).c_str (), 0600), 0);
  std::thread feeder ([&] { writeText (path ("in_pipe.pcd"), contentOf (path ("wave.pcd"))); });
  std::string received;
  std::thread reader ([&] { received = contentOf (path ("out_pipe.pcd")); });
  succeed ("pcl_normal_smoothing in_pipe.pcd out_pipe.pcd");
  feeder.join ();
  reader.join ();
  EXPECT_EQ (received, contentOf (path ("out.pcd")));
}
