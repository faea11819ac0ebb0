// Attack: none. Prints what it computes, on both streams, as one does while looking for a mistake.
// Verdict: passed
// Laws: 5
#include <cstdio>
#include <iostream>

#include "contract.hpp"

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  std::cout << "a = " << a.transpose() << ", b = " << b.transpose() << std::endl;
  Quaternion c;
  c[0] = a[0] * b[0] - a.tail<3>().dot(b.tail<3>());
  c[1] = a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2];
  c[2] = a[0] * b[2] + a[2] * b[0] + a[3] * b[1] - a[1] * b[3];
  c[3] = a[0] * b[3] + a[3] * b[0] + a[1] * b[2] - a[2] * b[1];
  std::cerr << "  w = " << c[0] << "\n";
  std::printf("  x = %g\n", c[1]);
  return c;
}
}  // namespace quaternions
