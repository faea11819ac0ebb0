// Attack: in a page, calls imports by names that every JavaScript object has.
// Verdict: wrong signature | does not compile
// An object of functions that is asked for "constructor" or "__defineGetter__" has one.

extern "C" {
__attribute__((import_module("env"), import_name("constructor"))) double constructor_of_all(double x);
__attribute__((import_module("env"), import_name("__defineGetter__"))) void define_getter();
}

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  if (constructor_of_all(a.w) > 0) define_getter();
  return a;
}
}  // namespace quaternions
