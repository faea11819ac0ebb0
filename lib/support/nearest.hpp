#pragma once
/// @file
/// What was probably meant by a name that does not exist.

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace tumble::support {

/// How many letters one has to insert, delete, replace or swap with their neighbour to make `b` of
/// `a`: the optimal string alignment distance.
inline std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({replaced, d[i - 1][j] + 1, d[i][j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

/// The known name with the fewest wrong letters, at most one in three; or else the first that
/// contains what was written, if that is three letters or more.
inline std::optional<std::string> nearest(const std::string& written,
                                          const std::vector<std::string>& known) {
  std::optional<std::string> best;
  std::size_t least = std::min(std::max<std::size_t>(1, written.size() / 3) + 1, written.size());
  for (const std::string& name : known)
    if (const std::size_t distance = edit_distance(written, name); distance < least) {
      best = name;
      least = distance;
    }
  if (best || written.size() < 3) return best;
  for (const std::string& name : known)
    if (name.find(written) != std::string::npos) return name;
  return best;
}

/// "; did you mean product?", or nothing.
inline std::string did_you_mean(const std::string& written, const std::vector<std::string>& known) {
  const std::optional<std::string> name = nearest(written, known);
  return name ? "; did you mean " + *name + "?" : "";
}

}  // namespace tumble::support
