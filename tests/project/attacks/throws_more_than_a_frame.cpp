// Attack: an exception whose text does not fit into a message.
// Verdict: threw | malformed | crashed | out of memory

namespace quaternions {
Quaternion product(const Quaternion&, const Quaternion&) {
  throw std::runtime_error(std::string(50000000, 'z'));
}
}  // namespace quaternions
