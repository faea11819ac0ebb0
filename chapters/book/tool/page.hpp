#pragma once
/// @file
/// A page of the book as lines of Markdown.

#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace tumble::book {

namespace fs = std::filesystem;

/// A mistake in a page; the message begins with "file:line: ".
struct PageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Page {
  fs::path file;
  std::vector<std::string> lines;
};

/// A line of a quotation ("> text", or ">" alone).
bool is_quoted(const std::string& line);
/// The line without the "> " of a quotation; any other line as it is.
std::string unquoted(const std::string& line);

/// @throws PageError if the file cannot be read
Page read_page(const fs::path& file);
void write_page(const Page& page);

/// A page that is in no folder, with these lines.
Page page_of(const fs::path& file, const std::string& text);

/// "file:line: ", as every mistake begins. @param line from 0
std::string at(const Page& page, std::size_t line);

[[noreturn]] void fail(const Page& page, std::size_t line, const std::string& what);

/// The text without blanks around it.
std::string trimmed(const std::string& text);

/// The text without code spans: `` `a $x$` `` is no formula.
std::string without_code_spans(const std::string& line);

}  // namespace tumble::book
