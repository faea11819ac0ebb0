#pragma once
/// @file
/// What a figure asks of the engine that is made of a reader's functions.

#include <nlohmann/json_fwd.hpp>

namespace tumble::judge {

/// @param question {"topic", "numbers"}: student/figure_engine.cpp lists them
/// @return {"numbers"}, or {"outcome", "detail"} if there is no answer
nlohmann::ordered_json answer_for_figure(const nlohmann::json& question);

}  // namespace tumble::judge
