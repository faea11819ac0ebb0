#pragma once
/// @file
/// A built worker, and the walls that it is started behind.

#include <filesystem>
#include <string>
#include <vector>

#include "judge/sandbox/walls.hpp"

namespace tumble::judge {

/// How a worker is started: behind all walls, or with a sanitizer that needs some of them open.
struct WorkerProgram {
  std::filesystem::path file;
  Walls walls;
  std::vector<std::string> environment = {};
};

}  // namespace tumble::judge
