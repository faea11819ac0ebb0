/// @file
/// ./tumble mine: an engine of a student's functions, good, incomplete, wrong and broken.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "project/harness/command.hpp"

using tumble::test::CommandResult;
using tumble::test::run_command;
namespace fs = std::filesystem;

namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  tumble::require(value != nullptr, "ctest sets ", name);
  return value;
}

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A student who has done everything, until something is put in its place.
class Student {
 public:
  Student() {
    std::string name = fs::temp_directory_path() / "tumble-mine-XXXXXX";
    tumble::require(::mkdtemp(name.data()) != nullptr, "cannot make ", name);
    path_ = name;
    fs::copy(fs::path(variable("TUMBLE_ROOT")) / "solutions", files(), fs::copy_options::recursive);
  }
  Student(const Student&) = delete;
  Student& operator=(const Student&) = delete;
  ~Student() { fs::remove_all(path_); }

  fs::path files() const { return path_ / "files"; }
  std::string figure() const { return text_of(path_ / "mine.svg"); }
  nlohmann::json numbers() const { return nlohmann::json::parse(text_of(path_ / "mine.json")); }

  /// Another text for one of the files, `from` there replaced by `to`.
  void change(const std::string& file, const std::string& from, const std::string& to) const {
    std::string text = text_of(files() / file);
    const auto at = text.find(from);
    tumble::require(at != std::string::npos, file, " does not contain ", from);
    std::ofstream(files() / file) << text.replace(at, from.size(), to);
  }

  CommandResult mine(const std::string& options = "") const { return from(files(), options); }
  CommandResult from(const fs::path& folder, const std::string& options) const {
    return run_command("timeout 200 '" + variable("TUMBLE_JUDGE") + "' mine --from '" +
                       folder.string() + "' --svg '" + (path_ / "mine.svg").string() +
                       "' --json '" + (path_ / "mine.json").string() + "' " + options);
  }

 private:
  fs::path path_;
};

const fs::path stubs = fs::path(variable("TUMBLE_ROOT")) / "exercises";

/// The student's curve of this name on a problem.
nlohmann::json curve_of(const nlohmann::json& numbers, std::size_t problem,
                        const std::string& name) {
  for (const nlohmann::json& curve : numbers.at("problems").at(problem).at("curves"))
    if (curve.at("from") == "student" && curve.at("name") == name) return curve;
  return {};
}

}  // namespace

TEST_CASE("the solutions make an engine whose errors fall as their methods promise") {
  const Student student;
  const CommandResult result = student.mine();
  CHECK_MESSAGE(result.status == 0, result.output);
  CHECK(contains(result.output, "An engine of 25 functions, all of them yours."));
  const nlohmann::json numbers = student.numbers();
  CHECK(numbers.at("right") == true);
  REQUIRE(numbers.at("problems").size() == 3);
  const std::pair<const char*, double> orders[] = {{"Euler", 1}, {"midpoint", 2}, {"RK4", 4}};
  for (std::size_t problem = 0; problem < 3; ++problem) {
    // A thousand faces and more, each of their sums rounded: √1776 · 2⁻⁵³, with room.
    CHECK(numbers.at("problems")[problem].at("mass").at("error") < 1e-13);
    for (const auto& each : orders) {
      const double observed = curve_of(numbers, problem, each.first).at("order");
      CHECK_MESSAGE(std::abs(observed - each.second) < 0.5, each.first, " has the order ",
                    observed);
    }
  }
  const nlohmann::json closed_form = curve_of(numbers, 2, "closed form");
  CHECK(closed_form.at("points")[0].at("error") < 1e-12);
  for (const char* part : {"your RK4", "library DOP853", "All functions of this engine are yours."})
    CHECK(contains(student.figure(), part));
}

TEST_CASE("untouched stubs: all that is missing is named at once") {
  const Student student;
  const CommandResult result = student.from(stubs, "");
  CHECK(result.status == 1);
  for (const char* part :
       {"25 of yours are not there yet", "4.8   quaternion_dot", "exercises/09_rigid_body/dydt.cpp",
        "./tumble check 1.3", "./tumble mine --fill"})
    CHECK_MESSAGE(contains(result.output, part), result.output);
  CHECK(student.numbers().at("parts").size() == 25);
}

TEST_CASE("--fill: the solutions stand in for exactly what is missing, and this is said") {
  const Student student;
  const CommandResult result = student.from(stubs, "--fill");
  CHECK_MESSAGE(result.status == 0, result.output);
  CHECK(contains(result.output, "0 of them yours. From the solutions: 1.3 euler_step, 1.4"));
  CHECK(contains(student.figure(), "Not yours, but from the solutions: 1.3 euler_step"));
}

TEST_CASE("what does not compile, lacks its function, is not there or not finished") {
  const Student student;
  student.change("05_momentum/torque.cpp", "return", "retrun");
  student.change("04_quaternions/quaternion_dot.cpp", "const Quaternion& q", "Quaternion q");
  student.change("01_particles/rk4_step.cpp", "  return", "  throw NotImplemented{};\n  return");
  fs::remove(student.files() / "09_rigid_body/pack.cpp");
  const CommandResult result = student.mine();
  CHECK(result.status == 1);
  for (const char* part :
       {"4 of yours are not there yet", "torque           does not compile",
        "torque.cpp:9:", "quaternion_dot   wrong signature", "pack             there is no file",
        "rk4_step         still throws NotImplemented"})
    CHECK_MESSAGE(contains(result.output, part), result.output);
}

TEST_CASE("an engine that runs and is wrong: the law that it breaks, and the unit") {
  const Student student;
  student.change("04_quaternions/quaternion_dot.cpp", "product(spin, q)", "product(q, spin)");
  const CommandResult result = student.mine();
  CHECK(result.status == 1);
  for (const char* part :
       {"No method comes to the true motion with smaller steps", "Broken: the energy",
        "as if ω were in body axes", "✗ 4.8 quaternion_dot  wrong", "Next:  ./tumble check 4.8"})
    CHECK_MESSAGE(contains(result.output, part), result.output);
  const nlohmann::json numbers = student.numbers();
  CHECK(numbers.at("right") == false);
  CHECK(numbers.at("problems")[0].at("broken_by").at("energy") > 1e-3);
  CHECK(curve_of(numbers, 0, "RK4").at("points").back().at("error") > 1e-3);
}

TEST_CASE("crashes, endless loops and no numbers: named, and everything else goes on") {
  const Student student;
  student.change("01_particles/euler_step.cpp", "return",
                 "*static_cast<volatile int*>(nullptr) = 1;\n  return");
  student.change("01_particles/midpoint_step.cpp", "return", "return 0.0 / 0.0 * y;\n  return");
  student.change("10_only_what_a_scene_needs/energy_drift.cpp", "if (states.empty())",
                 "for (volatile int i = 0; i >= 0; i = 1) {}\n  if (states.empty())");
  const CommandResult result = student.mine();
  CHECK(result.status == 1);
  for (const char* part :
       {"1.3 euler_step, or what it steps: crashed: SIGSEGV",
        "1.4 midpoint_step, or what it steps: wrong: with 64 steps the state becomes no number",
        "10.3 energy_drift: hung", "Of your functions, these do not pass"})
    CHECK_MESSAGE(contains(result.output, part), result.output);
  CHECK(curve_of(student.numbers(), 0, "RK4").at("right") == true);
}
