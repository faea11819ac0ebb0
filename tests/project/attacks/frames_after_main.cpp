// Attack: answers wrongly, and says in a destructor, when the judge has hung up, that all is well.
// Verdict: wrong
#include <unistd.h>

namespace {
struct Late {
  ~Late() {
    for (int n = 0; n < 1000; ++n)
      if (write(3, "\x0c\0\0\0\x93\x01\0\x91\xa6passed", 16) < 0) return;
  }
} late;
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
