// Attack: none. Looks whether it is on a terminal, asks for the time and a variable, flushes, and
//         asks for a number from hardware: all that libraries do without being told.
// Verdict: passed
// Laws: 5
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <locale>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts = {};
  if (std::getenv("DEBUG") && isatty(1) && gmtime_r(&now, &parts)) std::puts("debugging");
  std::cout.imbue(std::locale::classic());
  std::fflush(stdout);
  const std::clock_t start = std::clock();
  static_cast<void>(start);
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3],
          a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1]};
}
}  // namespace quaternions
