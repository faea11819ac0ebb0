#pragma once
/// @file
/// Solutions as students spoil them.

#include <string>

#include "project/harness/inputs.hpp"

namespace tumble::bench {

/// A whole number, 0 or more and less than `count`.
std::size_t pick(test::Random& random, std::size_t count);

/// The source with one mistake in it, as students make them: a sign, a factor, a forgotten half,
/// a matrix that is not transposed, a line that is missing. Nearly always it still compiles.
std::string with_mistake(const std::string& source, test::Random& random);

/// The source with something missing that the compiler needs.
std::string that_does_not_compile(const std::string& source, test::Random& random);

}  // namespace tumble::bench
