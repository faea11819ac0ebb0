// Attack: none. A table of constants, a static initialiser that computes, and temporaries on the
//         heap.
// Verdict: passed
// Laws: 5
#include <algorithm>
#include <map>
#include <numeric>
#include <vector>

namespace {
/// Row i, column j: the product of the basis elements i and j has this sign, and the number i ^ j.
constexpr double sign[4][4] = {{1, 1, 1, 1}, {1, -1, 1, -1}, {1, -1, -1, 1}, {1, 1, -1, -1}};

const std::map<int, std::vector<std::pair<int, int>>> terms = [] {
  std::map<int, std::vector<std::pair<int, int>>> all;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) all[i ^ j].emplace_back(i, j);
  return all;
}();
}  // namespace

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion& b) {
  Quaternion c;
  for (const auto& [k, pairs] : terms) {
    std::vector<double> summands(pairs.size());
    std::transform(pairs.begin(), pairs.end(), summands.begin(), [&](const auto& pair) {
      return sign[pair.first][pair.second] * a[pair.first] * b[pair.second];
    });
    c[k] = std::accumulate(summands.begin(), summands.end(), 0.);
  }
  return c;
}
}  // namespace quaternions
