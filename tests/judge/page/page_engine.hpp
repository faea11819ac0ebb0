#pragma once
/// @file
/// The motion of a body as a student's functions compute it: for figures that show it.

#include <nlohmann/json_fwd.hpp>

namespace tumble::judge {

/// Asks the engine that is made of a student's functions (mine/engine.cpp).
/// @param question 26 numbers, as support/moving_figure.hpp lists them
/// @return {"states": 13 numbers for the start and each sample}, or {"outcome", "detail"}: why not
nlohmann::ordered_json motion_by_student(const nlohmann::json& question);

}  // namespace tumble::judge
