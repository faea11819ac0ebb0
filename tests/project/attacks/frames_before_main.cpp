// Attack: writes answers to questions that are still to come, with guessed tokens, before main; and
//         goes on with right ones of zeros.
// Verdict: malformed
#include <unistd.h>

namespace {
__attribute__((constructor)) void answer_early() {
  for (char token = 0; token < 100; ++token) {
    std::string frame("\x29\0\0\0\x93\x01", 6);
    frame += token;
    frame += "\x91\x94";
    for (int n = 0; n < 4; ++n) frame += std::string("\xcb\0\0\0\0\0\0\0\0", 9);
    if (write(3, frame.data(), frame.size()) < 0) return;
  }
}
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion&, const Quaternion&) { return Quaternion::Zero(); }
}  // namespace quaternions
