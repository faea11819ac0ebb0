// Attack: a table of 2 GB that starts with a one: the object file is as large.
// Verdict: too expensive to compile | does not compile

char bomb[std::size_t{1} << 31] = {1};

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
