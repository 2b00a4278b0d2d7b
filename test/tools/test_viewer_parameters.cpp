// SPDX-License-Identifier: BSD-3-Clause
#include "smoothing/smoothing_job.h"
#include "viewer/parameters.h"

#include <gtest/gtest.h>

using namespace pcl_normal_smoothing;
using tools::ViewerParameters;
using Given = ViewerParameters::Given;

namespace
{
const std::string rounds =
    "-preset default -normals wpca -k 32 -point_iterations 6 -noise_sigma 0.01 -point_spacing 0.1 "
    "-sheet_distance inf -max_displacement 0.05 -oriented 0 -seed 0";
const std::string chain = "-preset paper -normals pca -k 7 -weights gaussian -threshold 0.65 -normal_iterations 5";

ViewerParameters
parametersFor (const std::string& used, const Given& given = {})
{
  tools::Options known;
  tools::SmoothingJob job;
  job.addOptions (known);
  ViewerParameters parameters (given, known);
  parameters.setUsed (used);
  return parameters;
}

/** The options after pressing these keys, when smoothing reported \a used as its parameters. */
Given
press (const std::vector<std::string>& keys, const std::string& used, const Given& given = {})
{
  ViewerParameters parameters = parametersFor (used, given);
  for (const std::string& key : keys)
    parameters.press (key);
  return parameters.options ();
}
} // namespace

TEST (ViewerParameters, LettersMakeSmallerAndLarger)
{
  EXPECT_EQ (press ({"K"}, rounds), (Given {{"-k", "40"}}));
  EXPECT_EQ (press ({"k"}, rounds), (Given {{"-k", "24"}}));
  EXPECT_EQ (press ({"i"}, rounds), (Given {{"-point_iterations", "5"}}));
  EXPECT_EQ (press ({"S"}, rounds), (Given {{"-noise_sigma", "0.0125"}}));
  EXPECT_EQ (press ({"d"}, rounds), (Given {{"-max_displacement", "0.04"}}));
}

TEST (ViewerParameters, NoiseThatVariesStillDoesWhereSigmaIsChanged)
{
  EXPECT_EQ (press ({"S"}, rounds + " -noise_varies 1"), (Given {{"-noise_sigma", "0.0125"}, {"-noise_varies", "1"}}));
  EXPECT_EQ (press ({"S"}, rounds + " -noise_varies 0"), (Given {{"-noise_sigma", "0.0125"}}));
  EXPECT_EQ (press ({"Up", "Right"}, "-noise_varies 1 " + rounds), (Given {{"-noise_varies", "0"}}));
}

TEST (ViewerParameters, StayWithinTheirRanges)
{
  EXPECT_EQ (press ({"I"}, rounds), (Given {{"-point_iterations", "6"}}));
  EXPECT_EQ (press ({"I"}, chain + " -point_iterations 6"), (Given {{"-point_iterations", "7"}}));
  EXPECT_EQ (press ({"k"}, "-preset paper -k 3"), (Given {{"-k", "3"}}));
  EXPECT_EQ (press ({"k"}, "-preset default -k 7 -noise_sigma 0.01"), (Given {{"-k", "7"}}));
  EXPECT_EQ (press ({"n"}, "-preset paper -normal_iterations 0"), (Given {{"-normal_iterations", "0"}}));
}

TEST (ViewerParameters, ArrowsSelectAndChange)
{
  EXPECT_EQ (press ({"Down", "Down", "Right"}, rounds), (Given {{"-k", "40"}}));
  EXPECT_EQ (press ({"Down", "Down", "Up", "Right"}, rounds), (Given {{"-normals", "hough"}}));
  EXPECT_EQ (press ({"Up", "Right"}, rounds), (Given {{"-preset", "fast"}}));
  EXPECT_EQ (press ({"Left"}, rounds), (Given {{"-preset", "paper"}}));
  EXPECT_EQ (press ({"Down", "Down", "Down", "Down", "Right"}, chain), (Given {{"-threshold", "0.7"}}));
}

TEST (ViewerParameters, AParameterThatIsNotUsedCannotBeChanged)
{
  EXPECT_EQ (press ({"S"}, chain), Given {});
  EXPECT_EQ (press ({"n"}, rounds), Given {});
  EXPECT_EQ (press ({"F12", "x", "Shift_L"}, rounds), Given {});
}

TEST (ViewerParameters, PresetsBeginAnew)
{
  const Given given {{"-k", "20"}, {"-sigma_s", "0.2"}};
  EXPECT_EQ (press ({"2"}, rounds, given), (Given {{"-preset", "fast"}}));
  EXPECT_EQ (press ({"Right"}, rounds, given), (Given {{"-preset", "fast"}}));
  EXPECT_EQ (press ({"3", "0"}, rounds, given), given);
}

TEST (ViewerParameters, BackspaceLetsThePresetDecide)
{
  EXPECT_EQ (press ({"K", "BackSpace"}, rounds), Given {});
  EXPECT_EQ (press ({"K", "S", "BackSpace"}, rounds), (Given {{"-k", "40"}}));
}

TEST (ViewerParameters, OnlyAChangeIsToldOf)
{
  ViewerParameters parameters = parametersFor (rounds);
  EXPECT_FALSE (parameters.press ("Down"));
  EXPECT_TRUE (parameters.press ("K"));
  EXPECT_FALSE (parameters.press ("q"));
  EXPECT_TRUE (parameters.press ("BackSpace"));
  parameters.takeBack ();
  EXPECT_EQ (parameters.options (), (Given {{"-k", "40"}}));
}

TEST (ViewerParameters, TheTextMarksWhatIsSelectedAndWhatIsSet)
{
  ViewerParameters parameters = parametersFor (rounds, {{"-point_spacing", "0.1"}});
  parameters.press ("K");
  const std::string text = parameters.text ();
  EXPECT_NE (text.find ("> k "), std::string::npos) << text;
  EXPECT_NE (text.find ("0.1 *\n"), std::string::npos) << text;
  EXPECT_NE (text.find ("  sheet_distance"), std::string::npos) << text;
  EXPECT_EQ (text.find ("seed"), std::string::npos) << text;
}
