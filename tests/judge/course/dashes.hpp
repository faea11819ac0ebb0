#pragma once
/// @file
/// Dashes that people and editors write for a hyphen.

#include <string>

namespace tumble::judge {

/// The text with a hyphen for each dash that looks like one: "1-4" for "1–4".
std::string with_hyphens(std::string text);

}  // namespace tumble::judge
