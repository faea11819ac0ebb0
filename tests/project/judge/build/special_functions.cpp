/// @file
/// The special functions of the standard library are compiled once, for all: a student's file finds
/// each of them.
#include <doctest/doctest.h>

#include <string>

#include "judge/build/work_folder.hpp"
#include "judge/build/worker_build.hpp"
#include "project/judge/attacks/submission.hpp"
#include "support/text_file.hpp"

using namespace tumble::judge;
namespace test = tumble::test;

namespace {

/// Not every standard library has them.
constexpr const char* calls_of_all = R"(
#include <cmath>
#ifdef __cpp_lib_math_special_functions
template <class T>
T sum_of_all(T x) {
  return std::assoc_laguerre(1, 1, x) + std::assoc_legendre(1, 1, x) + std::beta(x, x) +
         std::comp_ellint_1(x) + std::comp_ellint_2(x) + std::comp_ellint_3(x, x) +
         std::cyl_bessel_i(x, x) + std::cyl_bessel_j(x, x) + std::cyl_bessel_k(x, x) +
         std::cyl_neumann(x, x) + std::ellint_1(x, x) + std::ellint_2(x, x) +
         std::ellint_3(x, x, x) + std::expint(x) + std::hermite(1, x) + std::laguerre(1, x) +
         std::legendre(1, x) + std::riemann_zeta(x) + std::sph_bessel(1, x) +
         std::sph_legendre(1, 1, x) + std::sph_neumann(1, x);
}
float sum_of_floats(float x) { return sum_of_all(x); }
double sum_of_doubles(double x) { return sum_of_all(x); }
long double sum_of_long_doubles(long double x) { return sum_of_all(x); }
#endif
)";

}  // namespace

TEST_CASE("a student's file may call each special function, with sanitizers and without") {
  const WorkFolder work;
  const Course course =
      read_course(test::variable("TUMBLE_FIXTURE") / ".." / "tumble_fixture_judge.json");
  const Unit& unit = course.units.front();
  const Job job{course, unit, work.path() / (unit.name + ".cpp"), work.path() / "job"};
  tumble::support::write_text(job.source,
                              tumble::support::read_text(course.solution(unit)) + calls_of_all);
  const WorkerBuild plain = build_worker(job);
  CHECK_MESSAGE(plain.outcome == BuildOutcome::built, plain.detail);
  const WorkerBuild sanitized = build_worker(job, Instrumentation::sanitizers);
  CHECK_MESSAGE(sanitized.outcome == BuildOutcome::built, sanitized.detail);
}
