#include "book/tool/addresses.hpp"

#include <algorithm>

namespace tumble::book {

std::string page_id(const fs::path& root, const fs::path& file) {
  fs::path path = fs::relative(file, root);
  if (path.filename() == "README.md")
    path = path.parent_path();
  else if (path.extension() == ".md")
    path.replace_extension();
  if (path.empty()) return "readme";
  std::string id = path.string();
  std::replace(id.begin(), id.end(), '/', '-');
  std::replace(id.begin(), id.end(), '.', '_');
  return id.substr(id.find_first_not_of('_'));
}

fs::path exercise_folder(const fs::path& root, const fs::path& file) {
  const fs::path path = fs::relative(file, root);
  const bool is_one = *path.begin() == "exercises" &&
                      (path.filename() == "contract.hpp" || path.filename() == "hints.md");
  return is_one ? file.parent_path() : fs::path();
}

std::string address_of(const fs::path& root, const fs::path& file) {
  if (const fs::path folder = exercise_folder(root, file); !folder.empty())
    return page_id(root, folder / "README.md") + ".html";
  const std::string id = page_id(root, fs::is_directory(file) ? file / "README.md" : file);
  return (id == "readme" ? "index" : id) + ".html";
}

bool is_public_header(const fs::path& root, const fs::path& file) {
  const std::string path = fs::relative(file, root).string();
  return path.starts_with("lib/include/") && path.ends_with(".hpp");
}

std::string exercise_anchor(const fs::path& root, const fs::path& folder,
                            const std::string& number) {
  return page_id(root, folder / "README.md") + "-" + number;
}

}  // namespace tumble::book
