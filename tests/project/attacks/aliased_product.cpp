// Attack: makes its function another name of a function of the C library.
// Verdict: wrong | crashed | does not compile | exited | malformed | hung

extern "C" double answer(double x) { return x; }
namespace quaternions {
__attribute__((alias("answer"))) Quaternion product(const Quaternion& a, const Quaternion& b);
}  // namespace quaternions
