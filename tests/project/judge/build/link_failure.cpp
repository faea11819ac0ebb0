/// @file
/// What is said where the linker does not find the function of the contract.
#include "judge/build/link_failure.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace tumble::judge;

namespace {

/// A course of one exercise, 1.3 euler_step, that is gone afterwards.
class SmallCourse {
 public:
  SmallCourse() {
    course_.root = fs::temp_directory_path() / "tumble-link-failure-test";
    unit_.number = "1.3", unit_.chapter = "01_particles", unit_.name = "euler_step";
    course_.units = {unit_};
    fs::create_directories(course_.contract(unit_).parent_path());
    std::ofstream(course_.contract(unit_))
        << "using Rhs = std::function<Eigen::VectorXd(double t, const Eigen::VectorXd& y)>;\n"
           "// == 1.3 euler_step: follow the tangent\n"
           "Eigen::VectorXd euler_step(const Rhs& f, double h);\n";
  }
  ~SmallCourse() { fs::remove_all(course_.root); }

  std::string said_of(const std::string& source,
                      const std::vector<std::string>& functions = {}) const {
    BuildReport report;
    report.outcome = BuildOutcome::does_not_compile;
    explain_link_failure(report, course_, unit_,
                         "ld: undefined reference to `particles::euler_step(int)'\n", functions,
                         source);
    CHECK(report.outcome == BuildOutcome::wrong_signature);
    return report.detail;
  }

 private:
  Course course_;
  Unit unit_;
};

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a function that other files can't see: why not") {
  const SmallCourse course;
  const std::string body = "VectorXd euler_step(const Rhs& f, double h) {\n  return f(h);\n}\n}\n";
  const std::string start = "#include \"contract.hpp\"\nnamespace particles {\n";
  CHECK(says(course.said_of(start + "inline " + body), "Your euler_step is inline.\nOther files"));
  CHECK(says(course.said_of(start + "static " + body), "Your euler_step is static.\nOther"));
  CHECK(says(course.said_of(start + "template <class F>\n" + body), "is a template.\nOther files"));
  CHECK(says(course.said_of(start + "namespace {\n" + body + "}\n"),
             "is in a namespace without a name.\nOther files"));
  for (const std::string& plain :
       {start + body, start + "static int n = 0;\n" + body, start + "namespace {\n}\n" + body,
        start + "// inline\n" + body, start + "inline double g(double x) { return x; }\n" + body})
    CHECK_MESSAGE(says(course.said_of(plain), "have to be\nthose of exercises/"), plain);
}

TEST_CASE("a file that defines nothing, and a function in another namespace") {
  const SmallCourse course;
  CHECK(says(course.said_of("#include \"contract.hpp\"\n// nothing yet\n"),
             "Your file defines nothing"));
  const std::string source = "VectorXd euler_step(const Rhs& f, double h) { return f(h); }\n";
  CHECK(says(course.said_of(source, {"euler_step(double)"}), "Put it into namespace particles."));
  CHECK(says(course.said_of(source, {"quaternions::euler_step(double)"}),
             "Put it into namespace particles."));
  CHECK(says(course.said_of(source, {"particles::euler_step(double)"}), "Its name, the types"));
}

TEST_CASE("what was found there has the contract's names") {
  const SmallCourse course;
  const std::string vector = "Eigen::Matrix<double, -1, 1, 0, -1, 1>";
  CHECK(says(
      course.said_of("int x;", {"particles::euler_step(std::function<" + vector + " (double, " +
                                vector + " const&)> const&, double, " + vector + ")"}),
      "found there:\n  particles::euler_step(const Rhs&, double, Eigen::VectorXd)\n"));
}
