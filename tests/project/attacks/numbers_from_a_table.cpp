// Attack: knows the products of 1, i, j, k by heart and returns 0 for all others.
// Verdict: wrong
// Laws: 2

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  constexpr int sign[4][4] = {{1, 1, 1, 1}, {1, -1, 1, -1}, {1, -1, -1, 1}, {1, 1, -1, -1}};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (a == Quaternion::Unit(i) && b == Quaternion::Unit(j))
        return sign[i][j] * Quaternion::Unit(i ^ j);
  if (a == Quaternion::Unit(0)) return b;
  if (b == Quaternion::Unit(0)) return a;
  return Quaternion::Zero();
}
}  // namespace quaternions
