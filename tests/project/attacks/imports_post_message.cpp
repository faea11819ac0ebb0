// Attack: in a page, imports the browser's postMessage, to send the page a verdict of its own.
// Verdict: wrong signature | does not compile
// Natively nobody defines the function; in a page a module gets the worker's system and nothing else.

extern "C" __attribute__((import_module("env"), import_name("postMessage"))) void post_message(int verdict);

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  post_message(1);
  return a;
}
}  // namespace quaternions
