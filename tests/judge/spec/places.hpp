#pragma once
/// @file
/// The numbers of an answer by their places, and which of them are wrong.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "judge/protocol/finding.hpp"

namespace tumble::judge {

using Places = std::vector<std::size_t>;

/// So many numbers are hardly written one by one: they come from a loop. Fewer are read at a
/// glance.
inline constexpr std::size_t of_a_loop = 6;

/// All numbers of a value in their order; nothing if it holds something
/// else too.
std::optional<std::vector<double>> numbers_in(const Value& value);

/// How many numbers of a value are not zero: a name from one number alone would be a guess.
std::size_t count_nonzero(const Value& value);

/// Whether this is a list of as many lists of numbers, each as long.
bool is_square_matrix(const Value& value);

/// Whether this is a list of numbers.
bool is_vector(const Value& value);

/// The places, among all numbers, where an answer is off by more than is allowed; nothing if it
/// does not have the shape of the demanded one, or is not of numbers alone.
std::optional<Places> wrong_places(const Finding& finding);

/// "place 5", "places 0 to 2 and 5", "places 5, 11 and 17", "places 5, 11, 17, …".
std::string text_of(const Places& places);

/// "Place 5", to begin a sentence.
std::string capitalised(std::string text);

/// The same in a plain vector or matrix: "row 1, column 2" of a matrix, or how many there are.
std::string text_of(const Places& places, const Value& answer);

}  // namespace tumble::judge
