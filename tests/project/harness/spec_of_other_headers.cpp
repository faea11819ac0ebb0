/// @file
/// A module like a spec's, but for the mark of its headers, which no judge has. None of it may run.
#include <cstdlib>

extern "C" {
extern const int tumble_spec_headers_of_nobody;
extern const int* const tumble_judge_of_spec;
const int* const tumble_judge_of_spec = &tumble_spec_headers_of_nobody;
}

namespace {
[[maybe_unused]] const bool runs = (std::abort(), true);
}
