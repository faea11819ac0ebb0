// Attack: a static table larger than all the memory it may have: it cannot even be started.
// Verdict: crashed | out of memory

namespace {
double table[std::size_t{1} << 27];
}

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  table[static_cast<std::size_t>(a.norm())] = 1;
  return a * table[0];
}
}  // namespace quaternions
