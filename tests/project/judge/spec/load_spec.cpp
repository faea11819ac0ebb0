/// @file
/// Which modules are taken for a spec of this judge.
#include "judge/spec/load_spec.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

using namespace tumble::judge;

namespace {

std::string refusal_of_spec(const fs::path& spec) {
  Unit unit;
  unit.number = "4.1";
  unit.chapter = "04_quaternions";
  unit.name = "product";
  unit.spec = spec;
  unit.worker = std::getenv("TUMBLE_ROOT");  // any path that is there
  try {
    load_spec(unit);
  } catch (const std::runtime_error& why) {
    return why.what();
  }
  return {};
}

}  // namespace

TEST_CASE("a spec of other headers is refused before anything of it runs") {
  CHECK(refusal_of_spec(std::getenv("TUMBLE_SPEC_OF_OTHER_HEADERS")) ==
        "the spec of 4.1 product was built with other headers than this judge: build the targets "
        "tumble_judge and spec.04_quaternions.product");
}

TEST_CASE("a spec that is not there is to be built") {
  CHECK(refusal_of_spec("/nowhere/product.so") ==
        "4.1 product is not built yet: build the target spec.04_quaternions.product");
}
