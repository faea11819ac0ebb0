#include "scenes/mesh_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>

#include "tumble/core/require.hpp"

namespace tumble::scenes {
namespace {

bool is_named_like_a_mesh(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".obj" || ending == ".stl" || ending == ".ply";
}

/// Files that a system hides are its own: macOS puts a `._part.stl` beside each `part.stl`.
bool is_hidden(const std::filesystem::path& path) {
  return path.filename().string().starts_with('.');
}

/// @throws std::invalid_argument if there are none
std::vector<std::string> meshes_in(const std::string& folder) {
  std::vector<std::string> files;
  bool deeper = false;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (is_hidden(entry.path())) continue;
    std::error_code broken_link;
    if (entry.is_directory(broken_link))
      deeper = true;
    else if (is_named_like_a_mesh(entry.path()))
      files.push_back(entry.path().string());
  }
  require(!files.empty(), folder, ": no .obj, .stl or .ply file in this folder",
          deeper ? "; we don't look into the folders in it: name them" : "");
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<std::string> mesh_files(const std::vector<std::string>& given) {
  std::vector<std::string> files;
  for (const std::string& path : given) {
    if (std::filesystem::is_directory(path)) {
      const std::vector<std::string> inside = meshes_in(path);
      files.insert(files.end(), inside.begin(), inside.end());
      continue;
    }
    require(path.find('=') == std::string::npos || std::filesystem::exists(path), path,
            ": there is no such file; for a density, write --density ", path);
    files.push_back(path);
  }
  return files;
}

}  // namespace tumble::scenes
