#pragma once
/// @file
/// What the fences of a page have to hold: code from the source, output from the programs.

#include <filesystem>
#include <string>
#include <vector>

#include "book/tool/fences.hpp"

namespace tumble::book {

struct Places {
  fs::path root;      ///< of the project
  fs::path programs;  ///< folder with the chapters' programs, each named like its chapter
};

/// What belongs into `fence` now.
/// @throws std::invalid_argument if the source is not there, std::runtime_error if a program fails
std::string wanted_content(const Places& places, const Fence& fence);

/// The fences whose content is stale: "file:line: …" each.
std::vector<std::string> stale_fences(const Places& places, const Page& page);

/// The page with every announced fence that is stale filled anew.
Page refreshed(const Places& places, const Page& page);

}  // namespace tumble::book
