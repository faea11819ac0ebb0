/// @file
/// What is found in a source file however it is written down.
#include "judge/build/inspection.hpp"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

using namespace tumble::judge;
namespace fs = std::filesystem;

namespace {

fs::path file_with(const std::string& text) {
  const fs::path file = fs::temp_directory_path() / "tumble-inspection-test";
  std::ofstream(file) << text;
  return file;
}

}  // namespace

TEST_CASE("the files of a rule, over several lines, with blanks in names") {
  const auto files = dependencies_of(file_with(
      "a.o: /x/a.cpp \\\n /usr/include/c++/12/cmath \\\n  /y/with\\ blank.hpp /z/../w/b.hpp\n"));
  CHECK(files == std::vector<fs::path>{"/x/a.cpp", "/usr/include/c++/12/cmath", "/y/with blank.hpp",
                                       "/w/b.hpp"});
}

TEST_CASE("Eigen/Core, the standard library and contracts are allowed, their neighbours are not") {
  const AllowedHeaders allowed(
      file_with("p.gch: /b/precompiled.hpp /usr/include/eigen3/Eigen/Core "
                "/usr/include/eigen3/Eigen/src/Core/Map.h /usr/include/c++/12/cmath "
                "/usr/include/c++/12/bits/std_abs.h /usr/include/stdlib.h\n"),
      {"/t/exercises/04_quaternions/contract.hpp"});
  for (const char* header :
       {"/usr/include/eigen3/Eigen/Core", "/usr/include/c++/12/cmath", "/usr/include/c++/12/random",
        "/usr/include/c++/12/pstl/execution_defs.h", "/usr/include/string.h",
        "/t/exercises/04_quaternions/contract.hpp"})
    CHECK_MESSAGE(allowed.contains(header), std::string(header));
  for (const char* header :
       {"/usr/include/eigen3/Eigen/Geometry", "/usr/include/eigen3/Eigen/src/Core/Other.h",
        "/usr/include/doctest/doctest.h", "/t/solutions/04_quaternions/product.cpp",
        "/t/exercises/04_quaternions/product.cpp", "/etc/passwd"})
    CHECK_MESSAGE(!allowed.contains(header), std::string(header));
}

TEST_CASE("without a list of what is allowed nothing is called forbidden") {
  CHECK_THROWS_WITH_AS(AllowedHeaders(file_with(""), {}),
                       doctest::Contains("precompiled header is not built"), std::runtime_error);
  CHECK_THROWS_AS(AllowedHeaders("/no/such/file", {}), std::runtime_error);
}

TEST_CASE("assembler is found where it stands, in any spelling") {
  for (const char* line : {"#APP", "\t.incbin \"/etc/passwd\"", "\t.INCBIN\t\"x\"",
                           "a: .Include \"x\"", "/*\"*/.incbin \"/etc/passwd\"",
                           "\t.ascii\t\"a\" ; .incbin \"b\"", "\t.macro x", "\t.irp y"}) {
    const std::string text = std::string("\t.text\n") + line + "\n\tret\n";
    CHECK_MESSAGE(line_with_assembler(file_with(text)) == 2, std::string(line));
  }
}

TEST_CASE("texts that speak of assembler are only texts") {
  const fs::path file = file_with(
      "\t.string\t\".incbin \\\"x\\\"\"\n\t.ascii\t\"#\\\\ .macro\"\n\tmovsd\t.LC0(%rip), %xmm0\n");
  CHECK(line_with_assembler(file) == 0);
}
