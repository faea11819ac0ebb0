// Attack: throws a number; a grader that catches std::exception only ends here.
// Verdict: threw

namespace quaternions {
Quaternion product(const Quaternion&, const Quaternion&) { throw 42; }
}  // namespace quaternions
