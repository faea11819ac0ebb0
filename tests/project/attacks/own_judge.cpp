// Attack: brings functions of the judge by their names: results that hold, a demand that is met.
// Verdict: wrong

namespace tumble::judge {
struct CloseTo;
struct UnitResult {
  bool passed() const;
  std::size_t passed_cases() const;
};
bool UnitResult::passed() const { return true; }
std::size_t UnitResult::passed_cases() const { return 5; }
struct Session {
  bool demand(std::size_t, const CloseTo&);
};
bool Session::demand(std::size_t, const CloseTo&) { return true; }
}  // namespace tumble::judge

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
