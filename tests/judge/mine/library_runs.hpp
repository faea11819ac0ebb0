#pragma once
/// @file
/// Runs of the library's methods, each compiled by itself: they are large templates.

#include "judge/mine/problem.hpp"

namespace tumble::judge::mine {

Point dop853(const Problem& problem, double tolerance);
/// By simulate(): a closed form where nothing pushes.
Point by_simulate(const Problem& problem, double tolerance);

}  // namespace tumble::judge::mine
