// Attack: floods the standard error before main, one character at a time.
// Verdict: flooded | hung
#include <cstdio>

namespace {
const int flood = [] {
  for (int n = 0; n < 100000000; ++n) std::fputc('x', stderr);
  return 0;
}();
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a * flood; }
}  // namespace quaternions
