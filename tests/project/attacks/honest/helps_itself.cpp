// Attack: none. Helper functions, a struct with operators, const-correct lambdas, clocks for
//         timing, random numbers and a sort that nothing depends on.
// Verdict: passed
// Laws: 5
#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>
#include <random>
#include <set>
#include <sstream>

namespace {
struct Timer {
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  ~Timer() {
    std::ostringstream text;
    text << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::clog << text.str() << " s\n";
  }
};
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const Timer timer;
  std::mt19937 random{std::random_device{}()};
  std::multiset<double> noise;
  for (int n = 0; n < 100; ++n) noise.insert(std::normal_distribution<>()(random));
  const auto copy = std::make_unique<Quaternion>(a);
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}
}  // namespace quaternions
