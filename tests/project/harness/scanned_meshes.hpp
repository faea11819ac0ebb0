#pragma once
/// @file
/// Scanned meshes for trial: they are not part of the project. Their tests run where the
/// environment variable TUMBLE_MESHES (set by ctest from the CMake variable) names their folder,
/// else they say so.

#include <cstdlib>
#include <filesystem>
#include <string>

#include "project/harness/skip.hpp"

namespace tumble::test {

/// Whether the folder of scanned meshes is there; if not, the test case counts as skipped.
inline bool have_scanned_meshes() {
  const char* folder = std::getenv("TUMBLE_MESHES");
  if (folder != nullptr && std::filesystem::exists(std::filesystem::path(folder) / "spot.obj"))
    return true;
  skip("the folder of scanned meshes is not here; set TUMBLE_MESHES");
  return false;
}

/// The path of a scanned mesh; only after have_scanned_meshes().
inline std::string scanned_mesh(const std::string& file) {
  return (std::filesystem::path(std::getenv("TUMBLE_MESHES")) / file).string();
}

}  // namespace tumble::test
