// Attack: floods the standard output; a grader that keeps it all runs out of memory or disk.
// Verdict: flooded | hung
#include <cstdio>
#include <string>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  const std::string line(4000, 'x');
  for (int n = 0; n < 1000000; ++n) std::puts(line.c_str());
  return a;
}
}  // namespace quaternions
