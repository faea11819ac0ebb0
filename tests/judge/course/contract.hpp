#pragma once
/// @file
/// What a contract says about one unit, and the stub that follows from it.

#include <string>
#include <vector>

#include "judge/course/course.hpp"

namespace tumble::judge {

/// The declaration of one unit in its contract.hpp.
struct Declaration {
  std::string title;                    ///< "the product of two quaternions"
  std::string signature;                ///< up to and without the semicolon, on one line or more
  std::vector<std::string> parameters;  ///< their names, in order
  std::vector<std::string> types;       ///< and their types: "const Body&"
  std::string result;                   ///< type of the result
};

/// Reads the part of `contract` that is headed `// == 4.1 product: the product of two quaternions`.
/// @throws std::runtime_error naming the contract if the heading or the declaration is missing
Declaration read_declaration(const Course& course, const Unit& unit);

/// Where a student asks for a hint and a verdict: on the command line, or by the buttons of a page.
enum class Help { commands, buttons };

/// The untouched exercise: what `reset` writes, and what a test compares the files with.
std::string stub_of(const Course& course, const Unit& unit, Help help = Help::commands);

}  // namespace tumble::judge
