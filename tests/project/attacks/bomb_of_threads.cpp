// Attack: starts threads that spin (at most 200, for 5 s, should nobody stop it).
// Verdict: forbidden
#include <chrono>
#include <thread>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  for (int n = 0; n < 200; ++n)
    std::thread([end] {
      while (std::chrono::steady_clock::now() < end) {
      }
    }).detach();
  return a;
}
}  // namespace quaternions
