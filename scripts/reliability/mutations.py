#!/usr/bin/env python3
"""Breaks the code in named ways, one at a time, and shows that the tests notice.

usage: mutations.py [--only <part of a name>] [--jobs 2]

Works on a copy of the last commit, in build_mutations/. Prints a row for each break: what it is, which test noticed. Exit
status 1 where none did, or where the code to break is no longer there."""
# SPDX-License-Identifier: BSD-3-Clause
import argparse
import os
import signal
import subprocess
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
WORK = os.path.join(ROOT, "build_mutations")
SOURCE = os.path.join(WORK, "source")
BUILD = os.path.join(WORK, "build")
LIBRARY_TESTS = ["test_core", "test_filters", "test_features", "test_clouds"]
KERNELS = "src/core/kernels/"
CORE = "src/core/"
TILES = "tools/tiles/"
HEADERS = "include/pcl_normal_smoothing/"

# name, file, what stands there, what is put in its place
MUTATIONS = [
    ("clumps: no noise is looked for in them", CORE + "wide_noise.cpp", "return ratio > read_in_clumps &&", "return false &&"),
    ("wide noise: smoothing takes it as it is read", CORE + "smoothing_preparation.cpp", "noise.sigma *= wide_noise_factor;", ";"),
    ("search: what is left behind the last whole vector", KERNELS + "nearest.h", "if (first < candidates.count)", "if (false)"),
    ("search: keys behind the last pair have no rank", KERNELS + "nearest.h", "if (j < count)", "if (false)"),
    ("graph: changed rows are not the shortest", CORE + "neighbor_graph.cpp", "std::min (graph->min_row_length_, graph->row (nodes[i]).size ())",
     "graph->min_row_length_"),
    ("graph: the shortest of rows of all lengths", CORE + "neighbor_graph_rows.h", "length = std::min (length, row.size () + 1);", ";"),
    ("noise: a short row of the sample has neighbours behind its end", CORE + "noise_sample.cpp", "row[j] == row[0] ? lane : i", "i"),
    ("flips: a normal is not turned to the side of the point's", KERNELS + "normal_filter.h",
     "return oriented ? number : withSignOf (number, cosine);", "return number;"),
    ("eq. 3: the weight is not squared", KERNELS + "normal_filter.h", "return inside * inside;",
     "return kind == 0 ? inside : inside * inside;"),
    ("eq. 2: the point's own normal is left out", KERNELS + "normal_filter.h", "j == 0 ? no_nodes : own", "own"),
    ("eq. 4: the distance has no weight", KERNELS + "normal_filter.h", "if (kind != 0)", "if (false)"),
    ("eq. 5: sigma_c counts the point itself", KERNELS + "normal_filter.h", "sigma_c = sum / count;",
     "sigma_c = sum / (count + 1);"),
    ("eq. 5: sigma squared twice", CORE + "normal_filter.cpp", "1 / (2 * options.sigma_s * options.sigma_s)",
     "1 / (2 * options.sigma_s * options.sigma_s * options.sigma_s * options.sigma_s)"),
    ("eq. 6: the weight is not squared", KERNELS + "normal_filter.h", "return inside * inside;",
     "return kind == 0 ? inside * inside : inside;"),
    ("eq. 7: printed and root mean square are swapped", KERNELS + "normal_filter.h", "step.rms ? ", "!step.rms ? "),
    ("normal filter: the wrong buffer goes into the next iteration", CORE + "normal_filter.cpp",
     "normals.swap (filtered);", "if (iteration == 0) normals.swap (filtered);"),
    ("normal filter: nodes without a normal are taken to have one", CORE + "normal_filter.cpp",
     "haveAllNormals (normals)", "true"),
    ("point update: nodes without a normal are taken to have one", CORE + "point_update.cpp",
     "haveAllNormals (normals)", "true"),
    ("rows with gaps are taken to be full", KERNELS + "kernels.cpp", "step.all_normals && rowsAreFull (rows)",
     "step.all_normals"),
    ("point update: the wrong buffer goes into the next iteration", CORE + "point_update.cpp",
     "positions.offset.swap (moved);", "if (iteration == 0) positions.offset.swap (moved);"),
    ("compensated update: the sum of the normals, not their mean", KERNELS + "point_update.h",
     "height = 0.5f * (turned", "height = (turned"),
    ("compensated update: the paper's term", KERNELS + "point_update.h",
     "if (compensated)", "if (false)"),
    ("point update: nothing is flipped", KERNELS + "point_update.h", "similarity (neighbor.cosine, step.oriented)",
     "similarity (neighbor.cosine, true)"),
    ("compensated update: the own normal stays on its side", KERNELS + "point_update.h",
     "difference), cosine, step.oriented)", "difference), cosine, true)"),
    ("eq. 9: sigma squared twice", CORE + "point_update.cpp", "1 / (2 * options.sigma_s * options.sigma_s)",
     "1 / (2 * options.sigma_s * options.sigma_s * options.sigma_s * options.sigma_s)"),
    ("eq. 9: the distance has no weight", KERNELS + "point_update.h", "neighbor.sq_dist * reach_factor",
     "0 * neighbor.sq_dist * reach_factor"),
    ("eq. 8: the sum goes the other way", KERNELS + "point_update.h", "+ scale * sum;", "- scale * sum;"),
    ("eq. 8: displacements of earlier iterations are lost", KERNELS + "point_update.h",
     "(load3OrZero (step.nodes.offset, own) - start) + scale * sum", "scale * sum"),
    ("the cap on the displacement does nothing", KERNELS + "local_points.h", "length > limit ? limit / length",
     "length > limit ? splat (1)"),
    ("search interval: an iteration too early", CORE + "point_update.cpp", "iteration > 0 && iteration %",
     "iteration > 0 && (iteration + 1) %"),
    ("k: one neighbour too many", CORE + "kd_tree_search.cpp", "query.k == 0 ? no_slot : query.k - 1;",
     "query.k == 0 ? no_slot : query.k;"),
    ("radius: a point at the radius is a neighbour", CORE + "kd_tree_search.cpp",
     "std::nextafter (radius * radius, 0.0f)", "radius * radius"),
    ("ties go to the order of the tree", CORE + "kd_tree.cpp", "rank.empty () ? element : rank[element]", "slot"),
    ("kd-tree: too small a ball", CORE + "kd_tree_search.cpp", "std::min (ball + half_diagonal, query.radius)",
     "std::min (ball, query.radius)"),
    ("kd-tree: no room for rounding", CORE + "kd_tree.cpp", "4 * std::numeric_limits<float>::epsilon () * largest",
     "0 * largest"),
    ("Hough: the winner stays in the turned frame", CORE + "hough.cpp", "return rotation.transpose () * bins",
     "return 1.0f * bins"),
    ("Hough: the seed is ignored", HEADERS + "hough_normal_estimation.h", "options_.seed = seed;", ";"),
    ("Hough: stops at the first triple", CORE + "hough.cpp", "lead * lead >= 4 * drawn", "lead >= 1"),
    ("Hough: fourth powers of lengths overflow", CORE + "hough.cpp", "point *= scale;", "point *= 1;"),
    ("WPCA: weights grow with the distance", CORE + "local_surface.cpp", "moments.add (difference, 1 / distance);",
     "moments.add (difference, distance);"),
    ("PCA: about the point, not the centroid", CORE + "local_surface.cpp",
     "outer_ / weight_ - sum_ * sum_.transpose () / (weight_ * weight_)", "outer_ / weight_"),
    ("noise: degrees of freedom of a plane, not a quadric", KERNELS + "quadric_fit.h", "/ (size - 6)", "/ (size - 3)"),
    ("noise: the spacing is too large", CORE + "noise_estimate.cpp", "std::sqrt (pi / 8)", "std::sqrt (pi / 4)"),
    ("rounds: sigma, not its square, is the gain", CORE + "robust_smoothing.cpp",
     "variance = options_.noise.sigma * options_.noise.sigma", "variance = options_.noise.sigma"),
    ("rounds: the whole step is taken", KERNELS + "step_control.h", "offset + share * step", "offset + step"),
    ("rounds: the way since the first round is not counted", KERNELS + "step_control.h", "if (!control.first_round) {",
     "if (false) {"),
    ("rounds: of two weights in a byte the first counts twice", KERNELS + "step_control.h", "add (pair >> 4, j + 1)",
     "add (pair & 15, j + 1)"),
    ("Hough: a band of bins too far", KERNELS + "plane_votes.h", "b + 1 < votes.bands", "b < votes.bands"),
    ("rounds: normals are not fitted", CORE + "robust_smoothing.cpp", "      fitNormals (round);\n", ""),
    ("close sheets are not told apart", HEADERS + "core/sheet_test.h", "constexpr int min_other_neighbors = 3;",
     "constexpr int min_other_neighbors = 33;"),
    ("close sheets: there is no second vote", CORE + "sheet_separation.cpp", "if (!oriented && !nodes.empty ())", "if (false)"),
    ("close sheets: normals do not count in the second vote", CORE + "sheet_normals.cpp", "vote.agreement = agreement;", ""),
    ("close sheets: two peaks are not seen", CORE + "sheet_estimate.cpp", "min_peak_over_valley = 1.5", "min_peak_over_valley = 150"),
    ("close sheets: detail is taken for a sheet", CORE + "sheet_estimate.cpp", "min_peak_over_valley = 1.5", "min_peak_over_valley = 0"),
    ("close sheets: layers of a depth camera are sheets", CORE + "sheet_estimate.cpp", "if (sigma < least_sigma_of_gap * gap &&",
     "if (false &&"),
    ("close sheets: layers of a depth camera stay apart", CORE + "smoothing_preparation.cpp",
     "separated.sigma < least_noise_left * mixed.sigma", "false"),
    ("points that came close stay there", CORE + "robust_smoothing.cpp", "      keepApart ();\n", "      ;\n"),
    ("points that came close leave the edge", KERNELS + "keep_apart.h", "similarity (cosine, step.oriented) > 0.5f", "similarity (cosine, step.oriented) > -2"),
    ("points that were close before move apart", KERNELS + "keep_apart.h", "minimum (squareRoot (dot (way_before, way_before)), 0.5f * spacing)", "0.5f * spacing"),
    ("points that came close move off the surface", KERNELS + "keep_apart.h", "way - dot (way, normal) * normal", "way"),
    ("points that came close go beyond the cap", KERNELS + "keep_apart.h", "start + capped (moved - start, step.max_displacement)", "moved"),
    ("rounds: an outlier holds up all around it", KERNELS + "step_control.h", "= 3 * gainOf", "= 3e9f * gainOf"),
    ("rounds: the share of a step is the square", KERNELS + "step_control.h", "  share *= share;\n  share *= share;\n", "  share *= share;\n"),
    ("rounds: fitted normals are not filtered", CORE + "robust_smoothing.cpp", "        filterFitted (sigma_s);\n", "        ;\n"),
    ("layers: none are seen", CORE + "layer_estimate.cpp", "min_share_stepped = .1;", "min_share_stepped = 1.1;"),
    ("layers: all flat parts are some", CORE + "layer_estimate.cpp", "|| stepped <= min_share_stepped * off", ""),
    ("layers: the rims of plates are some", CORE + "layer_test.cpp", "max_share_beneath = .25;", "max_share_beneath = 1e9;"),
    ("layers: steps of any heights are", CORE + "layer_estimate.cpp", "max_deviation = .4f;", "max_deviation = 40;"),
    ("layers: in one direction only", CORE + "layer_estimate.cpp", "planes[s] && areParallel (*planes[s], common)",
     "planes[s] && areParallel (*planes[s], Eigen::Vector3d::UnitZ ())"),
    ("layers: neighbourhoods stay narrow", CORE + "neighborhood_widening.cpp", "std::min (most, ", "std::min (0, "),
    ("layers: rounding makes no noise", CORE + "noise_estimate.cpp", "std::max (noise.sigma, layers.noise_of_step * step)", "noise.sigma"),
    ("layers: frayed steps have no more noise", CORE + "layer_estimate.cpp", "+ .5 * (1 - share_stepped)", ""),
    ("layers: the noise is the same everywhere", CORE + "noise_estimate.cpp", "relativeField (layers.steps, step)", "NoiseField ()"),
    ("layers: the spacing is that of wide neighbourhoods", CORE + "noise_estimate.cpp", "of_wide.spacing = noise.spacing;", ""),
    ("layers: of a wall that faces the camera are sheets", CORE + "smoothing_preparation.cpp",
     "seen.gap < sheet_steps * largestStep ()", "false"),
    ("lines: none are seen", CORE + "line_estimate.cpp",
     "return isShare (min_share_of_lines, lines) || isShare (min_share_flat, planes);", "return false;"),
    ("lines: noise hides them", CORE + "line_estimate.cpp", "is_decided_ = !spread.isFlat (surely_flat);", "is_decided_ = true;"),
    ("lines: facets are some", CORE + "line_estimate.cpp", "max_cosine_to_surface = .7;", "max_cosine_to_surface = 2;"),
    ("lines: all neighbours are in one part", CORE + "neighborhood_widening.cpp", "Parts::ALL", "Parts::ONE"),
    ("lines: the noise is that within lines", CORE + "noise_estimate.cpp",
     "between == Between::LINES ? sigmaAcrossLines (variances) : ", ""),
    ("wide noise: it is not seen", CORE + "wide_noise.cpp", "if (!(ratio > read_surely))", "if (true)"),
    ("wide noise: close sheets are some", CORE + "wide_noise.cpp", "if (halvings == 0 || showsSheets", "if (halvings == 0 || false && showsSheets"),
    ("wide noise: leaves are a surface", CORE + "wide_noise.cpp", "return ratio < read_surely ? most : 0;", "return most;"),
    ("nobody can cancel while the noise is estimated", "src/smoothing_run.cpp", "execution.still ()", "execution.silent ()"),
    ("rounding: no step is found", CORE + "coordinate_rounding.cpp", "return std::isfinite (least) ? least : 0;", "return 0;"),
    ("rounding: an axis without a step does not count", CORE + "coordinate_rounding.cpp", "    if (std::abs (number - first - steps * step) > max_rounding * step)\n      return 0;\n", ""),
    ("rounding: of clean shapes it makes noise", CORE + "coordinate_rounding.cpp", "stepped > min_share_stepped * off", "true"),
    ("rounding: flat parts tell nothing", CORE + "coordinate_rounding.cpp", "step > 0 && graph.minRowLength () >= nearest_count &&", "false &&"),
    ("rounding: shells of voxels are sheets", CORE + "smoothing_preparation.cpp", "std::max (widening_.rounding.step,", "std::max (0.0f,"),
    ("samples: of points, not of places", CORE + "hash_sample.cpp", "if (limit == all && generous != all)\n      continue;", ""),
    ("copies: one without a normal makes all so", "src/smoothing_run.cpp", "      normal = of_copies[i];", "      ;"),
    ("copies: those without a normal move", "src/smoothing_run.cpp", "      displacements[i].setZero ();", "      ;"),
    ("copies: none are taken out", HEADERS + "search_settings.h", "query.distinct = joinsCopies ();", ""),
    ("copies: they stay where they are", CORE + "neighbor_graph.cpp", "of_nodes.push_back (of_nodes[node]);", "of_nodes.push_back (0 * of_nodes[node]);"),
    ("copies: a search object names them", CORE + "neighbor_graph.cpp", "row.erase (std::unique (", "(void)(std::unique ("),
    ("copies: all are on one side", "src/smoothing_run.cpp", "      normals[i] *= -1;", "      ;"),
    ("copies: those but for rounding hide the noise", CORE + "noise_sample.cpp", "copy_distance = 1e-3f;", "copy_distance = 0;"),
    ("noise along rays: slant is not seen", CORE + "residual_quantiles.cpp", "return below (between (lower, upper, of_12)", "return 0 * below (between (lower, upper, of_12)"),
    ("noise: far from the origin the sample is of a few places", CORE + "positions.cpp", "mix (positions.offset[i], hash);", ";"),
    ("noise that varies: one sigma for all", CORE + "noise_field.cpp", "!(trust > 0) ||", "true ||"),
    ("noise that varies: the fits do not know", KERNELS + "quadric_fit.h", "step.residual_factor / variance_factor *",
     "step.residual_factor *"),
    ("noise that varies: the update does not know", KERNELS + "point_update.h",
     "step.residual_factor / load1OrOne (step.variance_factors, own)", "splat (step.residual_factor)"),
    ("noise that varies: the risk does not know", KERNELS + "step_control.h",
     "control.gain * load1OrOne (control.variance_factors, own)", "splat (control.gain)"),
    ("noise that varies: the order of the points tells", CORE + "regional_field.cpp",
     "place[axis], place.x (), place.y (), place.z (), point.value", "place[axis]"),
    ("noise that varies: chance is enough", CORE + "noise_field.cpp", "return 1.4 + .04", "return 0 * 1.4 + 0 * .04"),
    ("noise that varies: sigma is that of even noise", CORE + "noise_estimate.cpp",
     "  if (!noise.field.isEven ())\n    estimateSigma (sample, between, noise);\n", ""),
    ("noise that varies: the parameters do not say so", "tools/method_options.cpp",
     'field.isEven () ? "0" : "1"', 'field.isEven () ? "0" : "0"'),
    ("tiles: the noise is the same everywhere", TILES + "plan_options.cpp",
     '  use ("rounds_noise_field", options.rounds.noise.field.factors.regions);\n', ""),
    ("points are displaced in the wrong unit", "src/vector_layout.cpp", "+ unit * displacements[node]",
     "+ displacements[node]"),
    ("clouds in small units are read as they are", "src/vector_layout.cpp", "std::abs (exponent) <= no_need",
     "exponent <= no_need"),
    ("indices are ignored", "src/vector_layout.cpp", "!selected[order[node]] || displacements",
     "displacements"),
    ("normals are not brought to length 1", "src/vector_layout.cpp", "(normal / length).cast<float> ()",
     "normal.cast<float> ()"),
    ("a cancelled run is not told from a failed one", "src/run_settings.cpp", "cancelled_ = true;", ";"),
    ("two points make a surface", "src/run_settings.cpp", "if (finite_points < 3)", "if (finite_points < 2)"),
    ("a graph of another cloud is taken", "src/run_settings.cpp",
     "neighbor_graph_->cloudSize () != cloud.size ()", "false"),
    ("an exception in a thread is lost", CORE + "parallel_for.cpp", "  if (failure)\n", "  if (false)\n"),
    ("normals point away from the viewpoint", HEADERS + "impl/surface_normal_estimation.hpp",
     "dot (to_view_point) < 0 ? -1.0f", "dot (to_view_point) > 0 ? -1.0f"),
    ("tools: what is half written stays", "tools/output_file.cpp", "    close (descriptor_);\n  removeOwnTemporary ();",
     "    close (descriptor_);"),
    ("tools: an interruption has the status of an error", "tools/tool.cpp", "_exit (128 + signal);", "_exit (2);"),
    ("tools: a header may claim more than the file holds", "tools/pcd_format.cpp",
     "points > available / bytes_per_point", "false"),
    ("tiles: no row is ever in doubt", TILES + "proof.cpp", "if (depth_.rows < 0 || all_.cells.allLoaded ())", "if (true)"),
    ("tiles: read in a unit of their own", TILES + "region.cpp", "records_.data (), size ()}, plan_.unit, execution_",
     "records_.data (), size ()}, execution_"),
    ("tiles: normals of the files in the wrong order", TILES + "region.cpp",
     "readNodeNormals ({record.normals (), records_.data (), size ()}, *searched_, execution_);",
     "readNormals ({record.normals (), records_.data (), size ()}, {searched_->order ().rbegin (), searched_->order ().rend ()});"),
    ("tiles: points in the order of the cells, not of their numbers", TILES + "region.cpp", "return a.number < b.number;",
     "return a.at < b.at;"),
    ("tiles: close sheets are not separated", TILES + "region.cpp", "if (depth.separation >= 0)", "if (false)"),
    ("tiles: the rows of a sample end two hops early", TILES + "region.cpp", "std::max (depth.separation, 0), query_",
     "std::max (depth.separation, 0) - 2, query_"),
    ("tree: the n-th is sought on the wrong side", HEADERS + "core/select_nth.h", "if (nth < middle)", "if (nth <= middle)"),
    ("tiles: a result is not compared with its checksum", TILES + "tile_result.cpp", "checksum.value () == written ?", "true ?"),
    ("tiles: all points into one file", TILES + "tile_merge.cpp", "points.add (tiles[i], ", "points.add (0 * tiles[i], "),
    ("tiles: a source may change", TILES + "smoothed_sources.cpp", "  if (!unchanged)\n", "  if (false)\n"),
    ("tools: a failed write is not noticed", "tools/output_file.cpp", "      fail (\"cannot be written\");",
     "      return;"),
]


def call(words, **more):
    return subprocess.run(words, check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **more)


def prepare(jobs):
    os.makedirs(SOURCE, exist_ok=True)
    subprocess.run(f"git -C '{ROOT}' archive HEAD | tar -xm --overwrite -C '{SOURCE}'", shell=True, check=True)
    subprocess.run(["cmake", "-S", SOURCE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                    "-DBUILD_EXAMPLES=OFF"], check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", BUILD, "--parallel", jobs, "--target", *LIBRARY_TESTS, "test_tools",
                    "test_tiles"], check=True)


def failure_of(test, jobs):
    """Which test of a program fails, of as many parts at once as there are jobs; nothing where all pass."""
    program = os.path.join(BUILD, "test", "" if test in LIBRARY_TESTS else "tools", test)
    parts = [subprocess.Popen([program, "--gtest_brief=1", "--gtest_fail_fast"], stdout=subprocess.PIPE, text=True,
                              stderr=subprocess.DEVNULL, start_new_session=True,
                              env={**os.environ, "OMP_WAIT_POLICY": "passive", "GTEST_TOTAL_SHARDS": jobs,
                                   "GTEST_SHARD_INDEX": str(part)}) for part in range(int(jobs))]
    failure = None
    for part in parts:
        try:
            printed = part.communicate(timeout=1 if failure else 600)[0]
        except subprocess.TimeoutExpired:
            os.killpg(part.pid, signal.SIGKILL)
            part.communicate()
            failure = failure or f"{test}, which does not end"
            continue
        if part.returncode != 0 and not failure:
            failed = [line for line in printed.splitlines() if line.startswith("[  FAILED  ]")]
            failure = failed[0].split("] ")[1].split(",")[0].split(" (")[0] if failed else f"{test}, which crashes"
    return failure


def noticed_by(tests, jobs):
    """The first test that fails; nothing where all pass."""
    built = call(["cmake", "--build", BUILD, "--parallel", jobs, "--target", *tests])
    if built.returncode != 0:
        return "does not compile"
    return next(filter(None, (failure_of(test, jobs) for test in tests)), None)


def tests_for(file):
    """Those that are likely to notice come first."""
    if file.startswith(TILES):
        return ["test_tiles"]
    if file.startswith("tools/"):
        return ["test_tools"]
    return LIBRARY_TESTS if CORE in file else LIBRARY_TESTS[1:] + LIBRARY_TESTS[:1]


def try_out(mutation, jobs):
    name, file, old, new = mutation
    path = os.path.join(SOURCE, file)
    with open(path, encoding="utf-8") as source:
        text = source.read()
    if old not in text:
        return f"is no longer in {file}", False
    try:
        with open(path, "w", encoding="utf-8") as source:
            source.write(text.replace(old, new, 1))
        found = noticed_by(tests_for(file), jobs)
    finally:
        with open(path, "w", encoding="utf-8") as source:
            source.write(text)
    return (found or "NOBODY"), bool(found) and found != "does not compile"


def main():
    parser = argparse.ArgumentParser(description="Breaks the code in named ways and runs the tests.")
    parser.add_argument("--only", default="", help="part of the names of those to try")
    parser.add_argument("--jobs", default="2")
    arguments = parser.parse_args()
    prepare(arguments.jobs)
    chosen = [mutation for mutation in MUTATIONS if arguments.only in mutation[0]]
    caught = 0
    for mutation in chosen:
        found, good = try_out(mutation, arguments.jobs)
        caught += good
        print(f"| {mutation[0]} | {found} |", flush=True)
    print(f"{caught} of {len(chosen)} are noticed")
    return 0 if caught == len(chosen) else 1


if __name__ == "__main__":
    sys.exit(main())
