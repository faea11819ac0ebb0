#pragma once
/// @file
/// What is not as it should be in an engine, and where to look for it.

#include <string>
#include <vector>

#include "judge/mine/measure.hpp"

namespace tumble::judge::mine {

/// Sentences, each about one thing that is wrong; none if everything is right. What follows from
/// another one is left out.
std::vector<std::string> diagnose(const Measurement& measurement);

/// Adds what is wrong with the impacts of a die.
void look_at_die(const DieResult& die, std::vector<std::string>& found);

/// "0.12 %"
std::string percent(double fraction);

}  // namespace tumble::judge::mine
