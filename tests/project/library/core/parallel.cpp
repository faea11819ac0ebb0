#include "tumble/core/parallel.hpp"

#include <doctest/doctest.h>

#include <numeric>

#include "project/harness/refusal.hpp"

using namespace tumble;
using namespace tumble::detail;

TEST_CASE("parallel_for: does every piece once, however many threads there are") {
  for (const int threads : {1, 2, 3, 8}) {
    for (const int count : {0, 1, 2, 7, 1000}) {
      std::vector<std::atomic<int>> done(static_cast<std::size_t>(count));
      parallel_for(count, threads, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
      CAPTURE(threads);
      CAPTURE(count);
      for (const std::atomic<int>& times : done) CHECK(times == 1);
    }
  }
}

TEST_CASE("parallel_for: passes on what a piece throws, after the threads have ended") {
  for (const int threads : {1, 4}) {
    std::atomic<int> begun = 0;
    const auto work = [&](int i) {
      ++begun;
      require(i != 3, "piece ", i);
    };
    CHECK_REFUSED(parallel_for(1'000'000, threads, work), "piece 3");
    CHECK(begun < 1'000'000);  // the others are not begun any more
  }
}

TEST_CASE("parallel_for: refuses no threads") {
  CHECK_REFUSED(parallel_for(1, 0, [](int) {}), "threads is 0");
}
