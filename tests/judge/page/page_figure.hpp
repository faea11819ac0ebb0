#pragma once
/// @file
/// What a figure asks of the engine that is made of a reader's functions.

#include <nlohmann/json_fwd.hpp>

namespace tumble::judge {

/// @param question a list of numbers, as student/figure_*.cpp say
/// @return {"numbers"}, or {"outcome", "detail"}: why the functions did not answer
nlohmann::ordered_json answer_for_figure(const nlohmann::json& question);

}  // namespace tumble::judge
