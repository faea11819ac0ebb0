// Attack: asks the linker by a pragma for further files: the solution's object, a library.
// Verdict: wrong | does not compile
#ifdef __clang__
#pragma comment(lib, "m")
#pragma comment(lib, "/etc/passwd")
#pragma comment(lib, "@ROOT@/solutions/04_quaternions/product.cpp")
#endif
__attribute__((section(".deplibs,\"MS\",@llvm_dependent_libraries,1#"), used))
const char library[] = "/etc/passwd";

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
