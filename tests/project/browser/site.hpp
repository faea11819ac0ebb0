#pragma once
/// @file
/// The site that was built, for tests that look at it in a browser.

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "project/harness/chromium.hpp"
#include "project/harness/skip.hpp"
#include "support/text_file.hpp"

namespace tumble::test {

/// Where the site lies; empty if it was not built.
inline std::filesystem::path site_folder() {
  const char* folder = std::getenv("TUMBLE_SITE");
  const std::filesystem::path site = folder ? folder : "";
  return std::filesystem::exists(site / "index.html") ? site : "";
}

/// Whether there is something to look at, and something to look with. Else says so.
inline bool can_look() {
  if (site_folder().empty()) return skip("the site is not built"), false;
  if (chromium_program().empty()) return skip("there is no Chromium"), false;
  return true;
}

inline std::string address_of(const std::string& page) {
  return "file://" + (site_folder() / page).string();
}

/// The pages of the book: those with a text that is ours.
inline std::vector<std::string> pages_of_the_book() {
  std::vector<std::string> pages;
  for (const auto& entry : std::filesystem::directory_iterator(site_folder())) {
    const std::string name = entry.path().filename().string();
    if (name == "index.html" || name.starts_with("chapters-") || name.starts_with("exercises-"))
      pages.push_back(name);
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

}  // namespace tumble::test
