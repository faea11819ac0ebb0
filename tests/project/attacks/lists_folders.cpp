// Attack: looks round in the folder of temporary files, where other submissions may lie.
// Verdict: forbidden
#include <filesystem>
#include <iostream>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  for (const auto& entry : std::filesystem::directory_iterator(".."))
    std::cout << entry.path() << std::endl;
  return a;
}
}  // namespace quaternions
