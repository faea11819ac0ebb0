#pragma once
/// @file
/// What a student's module asks of its system, in the words that a system call has natively.

#include <string>

namespace tumble::judge {

/// What a refused call of WASI was for: "open a file", "sleep", …
std::string purpose_of_wasi_call(const std::string& name);

}  // namespace tumble::judge
