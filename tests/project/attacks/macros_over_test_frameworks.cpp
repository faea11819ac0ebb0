// Attack: redefines what tests are made of; it works where the source is included by a test.
// Verdict: wrong signature
#define CHECK(...)
#define REQUIRE(...)
#define TEST_CASE(...) static void never()
#define DOCTEST_CONFIG_DISABLE
#define assert(x)
#define private public
#define const
#define double float
#define main not_main

namespace quaternions {
Quaternion product(const Quaternion& a, const Quaternion&) { return a; }
}  // namespace quaternions
