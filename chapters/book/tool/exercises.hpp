#pragma once
/// @file
/// "Now write 9.1": a block that the tool writes below `<!-- exercise: 9.1 -->`, from the contract
/// and the hints of the page's chapter.

#include <cstddef>
#include <string>
#include <vector>

#include "book/tool/page.hpp"

namespace tumble::book {

/// The announcement, and the quoted lines below it.
struct ExerciseBlock {
  std::string number;       ///< "9.1"
  std::size_t comment = 0;  ///< its line, from 0
  std::size_t end = 0;      ///< the line behind the block
};

/// "9.1" of the line `<!-- exercise: 9.1 -->`; empty for any other line.
std::string announced_exercise(const std::string& line);

std::vector<ExerciseBlock> exercise_blocks(const Page& page);

/// The numbers of all exercises in a contract, in its order.
std::vector<std::string> exercises_in(const fs::path& contract);

/// The contract of the page's chapter.
fs::path contract_of(const fs::path& root, const Page& page);

/// Blocks that are not what contract and hints say: "file:line: …" each.
std::vector<std::string> stale_exercises(const fs::path& root, const Page& page);

/// The page with each block written anew.
/// @throws PageError if the contract or the hints do not have the exercise
Page with_fresh_exercises(const fs::path& root, const Page& page);

}  // namespace tumble::book
