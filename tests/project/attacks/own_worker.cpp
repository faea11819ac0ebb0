// Attack: brings the worker itself, which says that it was never asked.
// Verdict: exited

namespace tumble::judge {
struct Value;
int serve_questions(const std::function<Value(const std::vector<Value>&)>&) { return 0; }
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
