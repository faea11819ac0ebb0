#pragma once
/// @file
/// Where a unit crashes: the same case again, with sanitizers.

#include <string>

#include "judge/build/job.hpp"
#include "judge/spec/run.hpp"

namespace tumble::judge {

/// "product.cpp:12: heap-buffer-overflow", or empty if the sanitizers do not see it.
std::string crash_place(const Job& job, const SpecRun& run);

}  // namespace tumble::judge
