#pragma once
/// @file
/// What a server of files says to a request.

#include <filesystem>
#include <string>

namespace tumble::book {

struct Answer {
  int status = 200;            ///< 200, 404: not there, 405: asked for more than reading, …
  std::string type;            ///< "text/html; charset=utf-8"
  std::filesystem::path file;  ///< what is sent; empty if nothing is
  bool with_content = true;    ///< not for HEAD

  /// The line of status and the headers.
  std::string head() const;
};

/// The file that an address means, percent signs decoded: of a folder its index.html. Nothing
/// outside the site is ever meant.
/// @param site    the folder, canonical
/// @param request its first line, "GET /exercises/units.json?again HTTP/1.1"
Answer answer_to(const std::filesystem::path& site, const std::string& request);

}  // namespace tumble::book
