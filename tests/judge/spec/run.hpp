#pragma once
/// @file
/// Runs the spec of one unit through doctest, case by case.

#include <cstdint>
#include <string>
#include <vector>

#include "judge/protocol/finding.hpp"
#include "judge/spec/answerer.hpp"

namespace tumble::judge {

/// One run of a spec, and what is wanted of it.
struct SpecRun {
  std::string unit;  ///< "04_quaternions/product"
  std::uint64_t seed = 1;
  std::size_t only_case = 0;  ///< 0: all of them
};

/// How many test cases the spec of a unit has.
std::size_t count_cases(const std::string& unit);

/// The result of every test case of the spec, in the order of its file.
/// @throws std::invalid_argument if there is no such spec, or no such case
std::vector<CaseResult> run_spec(const SpecRun& run, Answerer& answerer);

}  // namespace tumble::judge
