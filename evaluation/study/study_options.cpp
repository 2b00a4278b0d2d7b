// SPDX-License-Identifier: BSD-3-Clause
#include "study/study_options.h"

#include "files/tool_error.h"
#include "models/made_models.h"

#include <algorithm>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
constexpr int most_subdivisions = 6;

/** Reads values separated by commas, each with the reader that \a makeReader makes for its destination. */
template <typename T, typename MakeReader>
tools::OptionReader
listOption (std::vector<T>& values, const MakeReader& makeReader)
{
  return [&values, makeReader] (const std::string& text) {
    values.clear ();
    const tools::OptionReader reader = makeReader ([&] (T value) { values.push_back (value); });
    for (std::size_t begin = 0; begin <= text.size ();) {
      const std::size_t end = std::min (text.find (',', begin), text.size ());
      reader (text.substr (begin, end - begin));
      begin = end + 1;
    }
  };
}

std::string
joined (const std::vector<std::string>& words)
{
  std::string list;
  for (const std::string& word : words)
    list += (list.empty () ? "" : ",") + word;
  return list;
}

void
addModelOptions (tools::Options& options, StudyOptions& study)
{
  std::vector<std::string> names = madeModelNames ();
  names.push_back ("none");
  options.add ("-models", "NAME,...", "shapes made in code: " + joined (names), "double_torus",
               listOption (study.models, [names] (const auto& use) {
                 return tools::wordOption (names, [names, use] (std::size_t i) { use (names[i]); });
               }));
  options.add ("-subdivide", "N,...", "how often to split the edges of every mesh in their middles; or one for all",
               "0", listOption (study.subdivisions, [] (const auto& use) {
                 return tools::integerOption (0, most_subdivisions, [use] (auto n) { use (static_cast<int> (n)); });
               }));
  const tools::Words<tools::NoiseType> types = tools::namedNoiseTypes ();
  options.add ("-noise", "GN,GR", "GN: along the normals, GR: along random directions", "GN,GR",
               listOption (study.noises, [types] (const auto& use) {
                 return tools::choiceOption<tools::NoiseType> (types, [use] (auto type) { use (type); });
               }));
  options.add ("-sigma", "S,...", "standard deviations of the noise, in mean edge lengths of the mesh", "0.2",
               listOption (study.sigmas, [] (const auto& use) { return tools::numberOption (0, 1e6, use); }));
  options.add ("-seeds", "N", "seeds 1 to N", "3; 1 with -small 1",
               tools::integerOption (1, 1000, [&study] (auto n) { study.seeds = static_cast<int> (n); }));
}

void
addMethodOptions (tools::Options& options, StudyOptions& study)
{
  options.add ("-sweep", "0|1", "the paper's 540 combinations, for the first seed", "1",
               tools::switchOption ([&study] (bool on) { study.sweep = on; }));
  options.add ("-measures", "paper|all", "what the sweep is measured by; paper: E_A and E_k alone", "all",
               tools::choiceOption<MeasureSet> ({{"paper", MeasureSet::PAPER}, {"all", MeasureSet::ALL}},
                                                [&study] (auto set) { study.sweep_measures = set; }));
  options.add ("-peers", "0|1", "the other methods, each as a process of its own", "1",
               tools::switchOption ([&study] (bool on) { study.peers = on; }));
  options.add ("-time_limit", "S", "seconds that a peer may take for a cloud", "120",
               tools::positiveOption ([&study] (double seconds) { study.time_limit = seconds; }));
  options.add ("-small", "0|1", "1: the peers' defaults alone", "0",
               tools::switchOption ([&study] (bool small) { study.small = small; }));
}
} // namespace

void
addStudyOptions (tools::Options& options, StudyOptions& study)
{
  addModelOptions (options, study);
  addMethodOptions (options, study);
}

void
readStudyFiles (const tools::Options& options, StudyOptions& study)
{
  study.folder = options.file (0);
  for (std::size_t i = 1; !options.file (i).empty (); ++i)
    study.meshes.push_back (options.file (i));
  if (!options.given ("-models"))
    study.models = {"double_torus"};
  if (study.models == std::vector<std::string> {"none"})
    study.models.clear ();
  if (study.small && !options.given ("-seeds"))
    study.seeds = 1;
  if (study.models.empty () && study.meshes.empty ())
    throw tools::UsageError ("there is nothing to study: give a mesh, or -models");
  if (study.subdivisions.size () > 1 && study.subdivisions.size () != study.meshes.size ())
    throw tools::UsageError ("-subdivide has " + std::to_string (study.subdivisions.size ()) + " numbers for " +
                             std::to_string (study.meshes.size ()) + " meshes: give one for each, or one for all");
}

} // namespace pcl_normal_smoothing::evaluation
