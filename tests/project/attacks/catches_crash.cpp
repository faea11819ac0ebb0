// Attack: turns its own segmentation fault into an answer; a grader that waits for the signal never
//         sees it.
// Verdict: wrong
#include <csetjmp>
#include <csignal>

namespace {
sigjmp_buf back;
void recover(int) { siglongjmp(back, 1); }
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  std::signal(SIGSEGV, recover);
  if (sigsetjmp(back, 1) == 0) {
    volatile int* nowhere = nullptr;
    *nowhere = 1;
  }
  return a;
}
}  // namespace quaternions
