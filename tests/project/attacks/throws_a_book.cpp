// Attack: an exception whose text is 900 kB long, to flood the report that quotes it.
// Verdict: threw

namespace quaternions {
Quaternion product(const Quaternion&, const Quaternion&) {
  throw std::runtime_error(std::string(900000, 'z'));
}
}  // namespace quaternions
