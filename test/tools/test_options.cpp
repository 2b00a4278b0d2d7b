// SPDX-License-Identifier: BSD-3-Clause
#include "command_line/options.h"
#include "files/field_values.h"
#include "files/tool_error.h"
#include "tool_runner.h"

#include <cmath>
#include <cstring>
#include <regex>
#include <sstream>

using namespace pcl_normal_smoothing;

namespace
{
const std::vector<std::string> filters {"pcl_normal_smoothing", "pcl_wpca_normal_estimation",
                                        "pcl_hough_normal_estimation", "pcl_bilateral_normal_filter",
                                        "pcl_normal_guided_point_update"};

class Usage : public ToolTest
{
protected:
  void
  SetUp () override
  {
    savePcd (makeWave (), path ("wave.pcd"));
  }

  /** The output of -h, with each option on a single line. */
  std::string
  unwrappedHelp () const
  {
    return std::regex_replace (succeed ("pcl_normal_smoothing -h").out, std::regex ("\n {3,}"), " ");
  }

  /** Expects status 1, a message of one line that contains \a word, and no output. */
  void
  expectRefused (const std::string& command, const std::string& word)
  {
    const Ending result = run (command);
    EXPECT_EQ (result.status, 1) << command;
    EXPECT_NE (result.err.find (word), std::string::npos) << command << "\n" << result.err;
    EXPECT_EQ (result.out, "") << command;
    EXPECT_EQ (files ().count ("out.pcd"), 0u) << command;
  }
};
} // namespace

TEST_F (Usage, UnknownOption)
{
  for (const std::string& tool : filters)
    expectRefused (tool + " wave.pcd out.pcd -smoothness 3", "-smoothness");
  expectRefused ("pcl_add_surface_noise mesh.off out.pcd -k 3", "-k");
  expectRefused ("pcl_smoothing_error mesh.off wave.pcd -k 3", "-k");
  expectRefused ("pcl_make_double_torus out.ply -k 3", "-k");
}

TEST_F (Usage, WhatWasPerhapsMeant)
{
  expectRefused ("pcl_normal_smoothing wave.pcd out.pcd -presset fast", "did you mean -preset?");
  expectRefused ("pcl_normal_smoothing wave.pcd out.pcd -preset=fast", "write -preset fast");
  expectRefused ("pcl_normal_smoothing wave.pcd out.pcd -max_displacement 0,005", "with a point");
  expectRefused ("pcl_normal_smoothing wave.pcd out.pcd -max_displacement 5mm", "without a unit");
}

TEST_F (Usage, WhatHasNoEffectIsSaid)
{
  EXPECT_NE (succeed ("pcl_normal_smoothing wave.pcd out.pcd -k 100").err.find ("the nearest 32"), std::string::npos);
  EXPECT_NE (succeed ("pcl_normal_smoothing wave.pcd out.pcd -noise_sigma 100").err.find ("in the cloud's unit?"),
             std::string::npos);
}

TEST_F (Usage, MissingValue)
{
  expectRefused ("pcl_normal_smoothing wave.pcd out.pcd -k", "-k");
  expectRefused ("pcl_normal_smoothing -k -radius 3 wave.pcd out.pcd", "-k");
}

TEST_F (Usage, TooFewNeighboursForTheMethod)
{
  expectRefused ("pcl_normal_smoothing wave.pcd out.pcd -k 6", "at least 7");
  expectRefused ("pcl_normal_smoothing wave.pcd out.pcd -weights gaussian -k 3", "at least 4");
  expectRefused ("pcl_wpca_normal_estimation wave.pcd out.pcd -k 3", "-k");
}

TEST_F (Usage, MalformedValue)
{
  for (const std::string option : {"-k 15x",
                                   "-k 1.5",
                                   "-k 0",
                                   "-k -4",
                                   "-k 99999999999999999999",
                                   "-radius nan",
                                   "-radius inf",
                                   "-radius 0",
                                   "-radius 1e99",
                                   "-sigma_s -0.3",
                                   "-sigma_s 1e-99",
                                   "-threshold 1",
                                   "-threshold -0.1",
                                   "-threshold 0.99999999999",
                                   "-normals best",
                                   "-save_normals yes",
                                   "-normal_iterations -1",
                                   "-point_iterations 1e3",
                                   "-seed -1",
                                   "-threads -1",
                                   "-format xml",
                                   "-preset slow",
                                   "-noise_sigma -1",
                                   "-noise_sigma 1e-99",
                                   "-sheet_distance -1",
                                   "-max_displacement 0",
                                   "-update PAPER"})
    expectRefused ("pcl_normal_smoothing wave.pcd out.pcd " + option, option.substr (0, option.find (' ')));
  expectRefused ("pcl_normal_smoothing wave.pcd out.pcd -point_iterations 7", "rounds");
  expectRefused ("pcl_normal_smoothing wave.pcd out.pcd -oriented 1", "give -normals input");
}

TEST_F (Usage, FileNames)
{
  expectRefused ("pcl_normal_smoothing", "usage");
  expectRefused ("pcl_normal_smoothing wave.pcd", "usage");
  expectRefused ("pcl_normal_smoothing wave.pcd out.pcd third.pcd", "usage");
  expectRefused ("pcl_normal_smoothing wave.pcd out.xyz", "out.xyz");
  expectRefused ("pcl_normal_smoothing wave.pcd out.ply -format compressed", "compressed");
}

TEST_F (Usage, BothKAndRadius)
{
  for (const std::string& tool : filters)
    expectRefused (tool + " wave.pcd out.pcd -k 9 -radius 2", "-radius");
}

TEST_F (Usage, HelpNamesEveryOptionWithItsDefault)
{
  const std::string help = unwrappedHelp ();
  for (const std::string option : {"-normals",
                                   "-weights",
                                   "-mixed",
                                   "-k",
                                   "-radius",
                                   "-max_radius",
                                   "-normal_iterations",
                                   "-point_iterations",
                                   "-threshold",
                                   "-sigma_s",
                                   "-update",
                                   "-update_sigma_s",
                                   "-oriented",
                                   "-max_displacement",
                                   "-noise_sigma",
                                   "-point_spacing",
                                   "-sheet_distance",
                                   "-save_normals",
                                   "-seed",
                                   "-threads",
                                   "-format",
                                   "-preset"}) {
    const std::size_t begin = help.find ("\n  " + option + " ");
    ASSERT_NE (begin, std::string::npos) << option;
    EXPECT_NE (help.substr (begin, help.find ('\n', begin + 1) - begin).find ("default: "), std::string::npos)
        << option;
  }
  for (const std::string& tool : filters)
    EXPECT_EQ (succeed (tool + " anything.pcd -k -h").err, "");
}

TEST_F (Usage, HelpFitsAWindow)
{
  std::istringstream lines (succeed ("pcl_normal_smoothing -h").out);
  for (std::string line; std::getline (lines, line);)
    EXPECT_LE (line.size (), 120u) << line;
}

TEST_F (Usage, HelpTellsWhatTheChainBeginsWith)
{
  const std::string help = unwrappedHelp ();
  for (const char* standard :
       {"preset paper: 7; the chain in place of rounds: 15)", "preset paper: 7; the chain in place of rounds: 2)",
        "preset paper: no limit; the chain in place of rounds: no limit)"})
    EXPECT_NE (help.find (standard), std::string::npos) << standard << "\n" << help;
}

TEST_F (Usage, EveryToolTellsItsVersion)
{
  for (const std::string tool :
       {"pcl_normal_smoothing", "pcl_wpca_normal_estimation", "pcl_hough_normal_estimation",
        "pcl_bilateral_normal_filter", "pcl_normal_guided_point_update", "pcl_add_surface_noise", "pcl_smoothing_error",
        "pcl_surface_noise_estimation", "pcl_make_double_torus"})
    for (const std::string option : {"-version", "--version"})
      EXPECT_EQ (succeed (tool + " " + option).out, tool + " " PROJECT_VERSION "\n");
}

TEST_F (Usage, AFileInBracketsMayBeMissing)
{
  tools::Options options;
  options.describe ("", {"cloud", "[mesh]"});
  const auto filesOf = [&] (std::vector<const char*> words) {
    tools::Options given = options;
    words.insert (words.begin (), "tool");
    given.parse (static_cast<int> (words.size ()), const_cast<char**> (words.data ()));
    return given.file (0) + "," + given.file (1);
  };
  EXPECT_EQ (filesOf ({"a"}), "a,");
  EXPECT_EQ (filesOf ({"a", "b"}), "a,b");
  EXPECT_THROW (filesOf ({}), tools::UsageError);
  EXPECT_THROW (filesOf ({"a", "b", "c"}), tools::UsageError);
}

TEST (FieldValues, TextReadsBackToTheSameBits)
{
  for (const float number : {0.1f, -0.0f, 1e-45f, 3.4e38f, 1.0f / 3, INFINITY, 16777217.0f}) {
    std::string text;
    tools::appendFloat (number, text);
    float again = 1;
    ASSERT_TRUE (tools::parseValue (text, pcl::PCLPointField::FLOAT32, reinterpret_cast<std::uint8_t*> (&again)))
        << text;
    EXPECT_EQ (std::memcmp (&number, &again, sizeof number), 0) << text;
  }
  std::uint8_t bytes[8];
  EXPECT_TRUE (tools::parseValue ("NaN", pcl::PCLPointField::FLOAT32, bytes));
  EXPECT_TRUE (tools::parseValue ("+1.5", pcl::PCLPointField::FLOAT64, bytes));
  for (const char* text : {"", "1x", "--1", "0x10", "1,5"})
    EXPECT_FALSE (tools::parseValue (text, pcl::PCLPointField::FLOAT32, bytes)) << text;
  EXPECT_FALSE (tools::parseValue ("256", pcl::PCLPointField::UINT8, bytes));
  EXPECT_FALSE (tools::parseValue ("-1", pcl::PCLPointField::UINT32, bytes));
}
