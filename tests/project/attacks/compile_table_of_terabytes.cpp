// Attack: a table of a terabyte of zeros, which costs the compiler nothing and the linker its
//         addresses.
// Verdict: too expensive to compile | does not compile | crashed

double bomb[std::size_t{1} << 37];

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
