// Attack: reads the solution while it runs and prints it.
// Verdict: forbidden
#include <fstream>
#include <iostream>

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  std::cout << std::ifstream("@ROOT@/solutions/04_quaternions/product.cpp").rdbuf() << std::flush;
  return a;
}
}  // namespace quaternions
