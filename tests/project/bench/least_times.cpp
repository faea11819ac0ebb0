#include "project/bench/least_times.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <limits>
#include <string>

namespace tumble::bench {
namespace {

/// Takes down the least time of each benchmark; their names are their places.
class LeastTimes : public benchmark::BenchmarkReporter {
 public:
  explicit LeastTimes(std::size_t count)
      : seconds(count, std::numeric_limits<double>::infinity()) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      double& least = seconds.at(std::stoul(run.run_name.function_name));
      least = std::min(least, run.real_accumulated_time / static_cast<double>(run.iterations));
    }
  }

  std::vector<double> seconds;
};

void initialize_once() {
  static const bool done = [] {
    std::string name = "bench", interleaving = "--benchmark_enable_random_interleaving=true";
    std::vector<char*> arguments = {name.data(), interleaving.data()};
    int count = 2;
    benchmark::Initialize(&count, arguments.data());
    return true;
  }();
  static_cast<void>(done);
}

void register_benchmark(std::size_t place, const Timed& timed) {
  const auto repeat = [run = timed.run](benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(run());
  };
  benchmark::RegisterBenchmark(std::to_string(place).c_str(), repeat)
      ->Repetitions(timed.repetitions)
      ->MinTime(timed.seconds)
      ->UseRealTime();
}

}  // namespace

std::vector<double> least_times(const std::vector<Timed>& all) {
  LeastTimes reporter(all.size());
  initialize_once();
  bool any = false;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].run) {
      register_benchmark(i, all[i]);
      any = true;
    }
  if (any) benchmark::RunSpecifiedBenchmarks(&reporter);
  benchmark::ClearRegisteredBenchmarks();
  return reporter.seconds;
}

}  // namespace tumble::bench
