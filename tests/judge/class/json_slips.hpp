#pragma once
/// @file
/// What a person writes into a JSON file who does not know the format, or whose editor does not.

#include <string>

namespace tumble::judge {

/// The first of these outside a text in quotes, with its place: quotes that a word
/// processor has made (“units”), single quotes, comments, a comma behind the last element. Empty if
/// there is none.
std::string json_slip_in(const std::string& text);

}  // namespace tumble::judge
