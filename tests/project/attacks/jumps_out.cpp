// Attack: leaves the function by longjmp, over the heads of its callers, back to before main.
// Verdict: crashed | exited | hung | wrong
#include <csetjmp>

namespace {
std::jmp_buf start;
__attribute__((constructor)) void remember() {
  if (setjmp(start) != 0) return;
}
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion&, const Quaternion&) { std::longjmp(start, 1); }
}  // namespace quaternions
