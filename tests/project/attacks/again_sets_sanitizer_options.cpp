// Attack: crashes, so that it is run again with sanitizers; gives them options of its own, to write
//         their report into a file.
// Verdict: crashed

extern "C" const char* __asan_default_options() { return "log_path=@OPEN@/report"; }

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  volatile int* nowhere = nullptr;
  *nowhere = 1;
  return a;
}
}  // namespace quaternions
