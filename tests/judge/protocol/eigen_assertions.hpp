#pragma once
/// @file
/// Eigen's assertions as exceptions, in everything that judges: an answer of the wrong size is then
/// a wrong answer, and no end of the judge. The build includes this file before any other.

#include <stdexcept>
#include <string>

namespace tumble::judge {

/// An operation of Eigen that the sizes at hand do not allow.
struct EigenAssertion : std::logic_error {
  using std::logic_error::logic_error;
};

[[noreturn]] inline void eigen_assertion_failed(const char* what) {
  throw EigenAssertion(std::string("its size does not fit (Eigen: ") + what + ")");
}

}  // namespace tumble::judge

#define eigen_assert(...) \
  ((__VA_ARGS__) ? static_cast<void>(0) : ::tumble::judge::eigen_assertion_failed(#__VA_ARGS__))
