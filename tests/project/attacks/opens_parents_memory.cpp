// Attack: opens the judge's memory as a file, to look for the expected answers.
// Verdict: forbidden
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <string>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  const std::string memory = "/proc/" + std::to_string(getpid() - 1) + "/mem";
  if (open(memory.c_str(), O_RDONLY) >= 0) std::puts("the judge's memory is open");
  return a;
}
}  // namespace quaternions
