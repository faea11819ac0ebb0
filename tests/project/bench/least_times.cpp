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
  explicit LeastTimes(const std::vector<Timed>& all)
      : seconds(all.size(), std::numeric_limits<double>::infinity()), all_(all) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration) continue;
      const std::size_t place = std::stoul(run.run_name.function_name);
      const double time = all_.at(place).clock == Clock::wall ? run.real_accumulated_time
                                                              : run.cpu_accumulated_time;
      seconds.at(place) = std::min(seconds.at(place), time / static_cast<double>(run.iterations));
    }
  }

  std::vector<double> seconds;

 private:
  const std::vector<Timed>& all_;
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
  benchmark::internal::Benchmark* const registered =
      benchmark::RegisterBenchmark(std::to_string(place).c_str(), repeat);
  registered->Repetitions(timed.repetitions)->MinTime(timed.seconds);
  if (timed.clock == Clock::wall) registered->UseRealTime();
}

}  // namespace

std::vector<double> least_times(const std::vector<Timed>& all) {
  LeastTimes reporter(all);
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
