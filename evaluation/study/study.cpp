// SPDX-License-Identifier: BSD-3-Clause
#include "study/study.h"

#include "command_line/tool.h"
#include "files/tool_error.h"
#include "models/made_models.h"
#include "models/mesh_model.h"
#include "results/study_file.h"
#include "study/families.h"

#include <algorithm>
#include <filesystem>
#include <memory>
#include <set>

namespace pcl_normal_smoothing::evaluation
{
namespace
{
void
makeFolder (const std::string& path)
{
  std::error_code error;
  std::filesystem::create_directories (path, error);
  if (error)
    throw tools::FileError (path, "cannot be made (" + error.message () + ")", "name another folder");
}

/** Carries out a study, from its options to its rows. */
class Study
{
public:
  explicit Study (const StudyOptions& options) : options_ (options)
  {
    makeFolder (options.folder + "/models");
    results_ = std::make_unique<Results> (options.folder);
  }

  StudyCounts
  run ()
  {
    makeModels ();
    loadMeshes ();
    saveStudyFile ();
    forEachCase ([&] (const Case& noisy_case) { plan (noisy_case); });
    for (const Model& model : models_)
      workOn (model);
    results_->save ();
    progress_.finish ();
    return counts ();
  }

private:
  template <typename Use>
  void
  forCasesOf (const Model& model, const Use& use) const
  {
    for (const tools::NoiseType noise : options_.noises)
      for (const double sigma : options_.sigmas)
        for (int seed = 1; seed <= options_.seeds; ++seed)
          use (Case {model, noise, sigma, static_cast<std::uint64_t> (seed)});
  }

  template <typename Use>
  void
  forEachCase (const Use& use) const
  {
    for (const Model& model : models_)
      forCasesOf (model, use);
  }

  void
  makeModels ()
  {
    for (const std::string& name : options_.models)
      addModel (name, [&] { return makeModel (name); });
  }

  void
  loadMeshes ()
  {
    for (std::size_t i = 0; i < options_.meshes.size (); ++i)
      addModel (modelName (options_.meshes[i]), [&] {
        const std::vector<int>& times = options_.subdivisions;
        return loadModel (options_.meshes[i], times[std::min (i, times.size () - 1)]);
      });
  }

  /** Adds the model that \a make returns, or failed rows if it throws. */
  template <typename Make>
  void
  addModel (const std::string& wanted_name, const Make& make)
  {
    std::string name = wanted_name;
    for (int number = 2; !names_.insert (name).second; ++number)
      name = wanted_name + "_" + std::to_string (number);
    try {
      Model model = make ();
      model.name = name;
      tools::saveMesh (model.mesh, options_.folder + "/models/" + name + ".ply");
      models_.push_back (std::move (model));
    }
    catch (const std::exception& error) {
      refuseModel (name, error.what ());
    }
  }

  /** Stores a failed row for every case of the model. */
  void
  refuseModel (const std::string& name, const std::string& reason)
  {
    tools::note ("model " + name + " is left out: " + reason);
    const Model nothing {name, {}, {}, {}};
    forCasesOf (nothing, [&] (const Case& noisy_case) {
      Row row = noisy_case.row ("noisy", "noisy", "");
      row.status = "failed";
      row.reason = reason;
      results_->put (row);
    });
  }

  void
  saveStudyFile () const
  {
    StudyFile file {options_.command_line, {}, options_.sigmas, {}};
    for (const tools::NoiseType noise : options_.noises)
      file.noises.push_back (tools::nameOf (noise));
    for (int seed = 1; seed <= options_.seeds; ++seed)
      file.seeds.push_back (static_cast<std::uint64_t> (seed));
    writeStudyFile (options_.folder, file, models_);
  }

  void
  plan (const Case& noisy_case)
  {
    planOwn (options_, noisy_case, *results_, progress_);
    planSweep (options_, noisy_case, *results_, progress_);
    planPeers (options_, noisy_case, *results_, progress_);
  }

  void
  workOn (const Model& model)
  {
    Evaluator evaluator (model);
    forCasesOf (model, [&] (const Case& noisy_case) {
      const tools::Points noisy = noisy_case.noisyPoints (evaluator.meanEdge ());
      evaluator.setNoisy (noisy);
      const CaseWork work {options_, noisy_case, evaluator, noisy, *results_, progress_};
      workOnOwn (work);
      workOnSweep (work);
      workOnPeers (work);
    });
  }

  StudyCounts
  counts () const
  {
    StudyCounts counts;
    for (const Row& row : results_->rows ())
      ++(row.ok () ? counts.ok : row.status == "failed" ? counts.failed : counts.absent);
    return counts;
  }

  const StudyOptions& options_;
  std::unique_ptr<Results> results_;
  std::vector<Model> models_;
  std::set<std::string> names_;
  Progress progress_;
};
} // namespace

StudyCounts
runStudy (const StudyOptions& options)
{
  return Study (options).run ();
}

} // namespace pcl_normal_smoothing::evaluation
