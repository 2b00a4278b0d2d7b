// SPDX-License-Identifier: BSD-3-Clause
//
// Google Benchmark of every stage: ./stages [--benchmark_filter=regex]. Besides the time it prints nanoseconds per
// point, and per edge and core, where an edge is one neighbour of one point.
#include "kd_tree.h"

#include <core/search/node_blocks.h>
#include <core/sheets/sheet_separation.h>
#include <pcl_normal_smoothing/core/noise/noise_estimate.h>
#include <pcl_normal_smoothing/core/smoothing.h>
#include <pcl_normal_smoothing/vector_layout.h>

#include <benchmark/benchmark.h>

#include <map>

namespace
{
using namespace pcl_normal_smoothing;
using benchmarks::Order;

/** The input of most stages; made once. */
struct Input
{
  benchmarks::Cloud::Ptr cloud;
  core::Positions positions;
  core::NeighborGraph::ConstPtr graph;
  core::Positions nodes;
  core::Vectors normals;
};

const Input&
inputOf (const benchmark::State& state, Order order = Order::RANDOM)
{
  static std::map<std::tuple<std::int64_t, std::int64_t, Order>, Input> inputs;
  const auto key = std::make_tuple (state.range (0), state.range (1), order);
  if (inputs.count (key) == 0) {
    inputs.clear (); // keep one at a time: the largest fill the memory
    Input& input = inputs[key];
    const core::Execution all (0);
    input.cloud = benchmarks::makeTorus (static_cast<std::size_t> (state.range (0)), order);
    input.positions = readPositions (positionsOf (*input.cloud), all);
    input.graph = core::NeighborGraph::build (input.positions, {static_cast<std::uint32_t> (state.range (1))}, all);
    input.nodes = gather (input.positions, input.graph->order ());
    input.normals = core::startNormals (*input.graph, input.nodes, all);
  }
  return inputs.at (key);
}

unsigned
threadsOf (const benchmark::State& state)
{
  return static_cast<unsigned> (state.range (2));
}

/** Adds the counters for \a passes over all edges per iteration. */
void
count (benchmark::State& state, int passes = 1)
{
  using benchmark::Counter;
  const double points = static_cast<double> (state.range (0)) * passes;
  const double edges = points * static_cast<double> (state.range (1));
  const auto per = [] (double number) {
    return Counter (number * 1e-9, Counter::kIsIterationInvariantRate | Counter::kInvert);
  };
  state.counters["ns/point"] = per (points);
  state.counters["ns/edge/core"] = per (edges / static_cast<double> (state.range (2)));
}

template <Order order>
void
buildGraph (benchmark::State& state)
{
  const Input& input = inputOf (state, order);
  const core::NeighborQuery query {static_cast<std::uint32_t> (state.range (1))};
  for (auto _ : state)
    benchmark::DoNotOptimize (core::NeighborGraph::build (input.positions, query, core::Execution (threadsOf (state))));
  count (state);
}

void
kdTreeOfPcl (benchmark::State& state)
{
  const Input& input = inputOf (state);
  for (auto _ : state)
    benchmarks::searchByKdTree (input.cloud, static_cast<int> (state.range (1)), static_cast<int> (state.range (2)));
  count (state);
}

void
startNormals (benchmark::State& state)
{
  const Input& input = inputOf (state);
  for (auto _ : state)
    benchmark::DoNotOptimize (core::startNormals (*input.graph, input.nodes, core::Execution (threadsOf (state))));
  count (state);
}

template <NormalSource source>
void
estimateNormals (benchmark::State& state)
{
  const Input& input = inputOf (state);
  for (auto _ : state)
    benchmark::DoNotOptimize (core::estimateNormals (*input.graph, input.nodes, core::makeEstimator (source, {}),
                                                     core::Execution (threadsOf (state))));
  count (state);
}

void
estimateNoise (benchmark::State& state)
{
  const Input& input = inputOf (state);
  for (auto _ : state)
    benchmark::DoNotOptimize (core::estimateNoise (*input.graph, input.nodes, core::Execution (threadsOf (state))));
  count (state);
}

void
separateSheets (benchmark::State& state)
{
  const Input& input = inputOf (state);
  const float distance = 4 * core::estimateNoise (*input.graph, input.nodes, core::Execution (0)).sigma;
  for (auto _ : state)
    benchmark::DoNotOptimize (
        core::separateSheets (input.graph, input.nodes, {distance, nullptr}, core::Execution (threadsOf (state))));
  count (state);
}

template <NormalWeight weight>
void
filterNormals (benchmark::State& state)
{
  const Input& input = inputOf (state);
  core::NormalFilterOptions options;
  options.weight = weight;
  options.iterations = 10;
  for (auto _ : state) {
    core::Vectors normals = input.normals;
    core::filterNormals (*input.graph, input.nodes, options, core::Execution (threadsOf (state)), normals);
  }
  count (state, options.iterations);
}

template <UpdateRule rule>
void
updatePoints (benchmark::State& state)
{
  const Input& input = inputOf (state);
  core::PointUpdateOptions options;
  options.rule = rule;
  options.iterations = 10;
  for (auto _ : state) {
    core::Positions nodes = input.nodes;
    core::updatePoints (input.graph, input.normals, options, {}, core::Execution (threadsOf (state)), nodes);
  }
  count (state, options.iterations);
}

template <bool fast>
void
smoothInRounds (benchmark::State& state)
{
  const Input& input = inputOf (state);
  core::RobustSmoothingOptions options;
  options.fast = fast;
  options.count = fast ? 3 : 6; // as in the presets
  options.noise = core::estimateNoise (*input.graph, input.nodes, core::Execution (0));
  options.max_displacement = 5 * options.noise.sigma;
  for (auto _ : state) {
    core::MovingSurface surface (input.nodes, input.normals);
    core::smoothRobustly (*input.graph, options, core::Execution (threadsOf (state)), surface);
  }
  count (state);
}

/** A limit of the machine: memory bandwidth, measured by reading two long arrays and writing a third. */
void
memoryBandwidth (benchmark::State& state)
{
  const auto size = static_cast<std::ptrdiff_t> (state.range (0)) * 16;
  std::vector<float> a (static_cast<std::size_t> (size), 1), b (a), c (a);
  const int threads = static_cast<int> (state.range (2));
  for (auto _ : state) {
#pragma omp parallel for num_threads(threads)
    for (std::ptrdiff_t i = 0; i < size; ++i)
      c[static_cast<std::size_t> (i)] = a[static_cast<std::size_t> (i)] + .5f * b[static_cast<std::size_t> (i)];
    benchmark::ClobberMemory ();
  }
  state.SetBytesProcessed (static_cast<std::int64_t> (state.iterations ()) * size * 12);
}

/** The work of a Gaussian or a mixed filter before its iterations. */
void
weighByDistance (benchmark::State& state)
{
  const Input& input = inputOf (state);
  std::vector<std::uint16_t> weights (input.graph->blockBegin (input.graph->blockCount ()));
  const core::DistanceWeights task {nodeArrays (input.nodes, input.normals), weights.data ()};
  for (auto _ : state)
    forEachBlock (*input.graph, core::Execution (threadsOf (state)),
                  [&] (const core::BlockRows& rows) { core::kernels ().distance_weights (task, rows); });
  count (state);
}

/** Several sizes, numbers of neighbours and numbers of threads, for the main stages; the others get oneSize. */
void
manySizes (benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames ({"points", "k", "threads"})->Unit (benchmark::kMillisecond)->UseRealTime ();
  for (const int threads : {1, 2})
    for (const int size : {10000, 100000, 1000000})
      benchmark->Args ({size, 16, threads});
  for (const int k : {7, 15, 21, 30})
    benchmark->Args ({1000000, k, 2});
}

void
oneSize (benchmark::internal::Benchmark* benchmark)
{
  benchmark->ArgNames ({"points", "k", "threads"})->Unit (benchmark::kMillisecond)->UseRealTime ();
  for (const int threads : {1, 2})
    benchmark->Args ({1000000, 16, threads});
}

BENCHMARK (buildGraph<Order::RANDOM>)->Apply (manySizes);
BENCHMARK (buildGraph<Order::ALONG_RINGS>)->Apply (manySizes);
BENCHMARK (kdTreeOfPcl)->Apply (manySizes);
BENCHMARK (startNormals)->Apply (oneSize);
BENCHMARK (estimateNormals<NormalSource::PCA>)->Apply (oneSize);
BENCHMARK (estimateNormals<NormalSource::WPCA>)->Apply (oneSize);
BENCHMARK (estimateNormals<NormalSource::HOUGH>)->Apply (oneSize);
BENCHMARK (estimateNoise)->Apply (oneSize);
BENCHMARK (separateSheets)->Apply (oneSize);
BENCHMARK (filterNormals<NormalWeight::THRESHOLD>)->Apply (manySizes);
BENCHMARK (filterNormals<NormalWeight::GAUSSIAN>)->Apply (manySizes);
BENCHMARK (filterNormals<NormalWeight::MIXED>)->Apply (manySizes);
BENCHMARK (updatePoints<UpdateRule::PAPER>)->Apply (manySizes);
BENCHMARK (updatePoints<UpdateRule::COMPENSATED>)->Apply (manySizes);
BENCHMARK (smoothInRounds<false>)->Apply (manySizes);
BENCHMARK (smoothInRounds<true>)->Apply (manySizes);
BENCHMARK (weighByDistance)->Apply (manySizes);
BENCHMARK (memoryBandwidth)->Apply (oneSize);
} // namespace

BENCHMARK_MAIN ();
