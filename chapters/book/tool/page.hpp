#pragma once
/// @file
/// A page of the book as lines of Markdown, and what in it is kept true: fences that show code or
/// output, formulas, figures, links.

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

/// A fenced block, and the comment in the line above that says what it shows:
/// `<!-- snippet: lib/include/tumble/rotation/skew.hpp#skew -->`, the same with `signature`, or
/// `<!-- output: 03_rotation_matrices#drift -->`, the same with `measured` where numbers are times.
struct Fence {
  std::size_t opening = 0, closing = 0;  ///< line numbers of the two fences, from 0
  std::string language;                  ///< "cpp", "text", "math", …
  std::string source;                    ///< "snippet", "signature", "output", "measured"; or empty
  std::string path, region;              ///< before and after the #
  bool quoted = false;                   ///< every line of it begins with "> "
};

/// A line of a quotation ("> text", or ">" alone).
bool is_quoted(const std::string& line);
/// The line without the "> " of a quotation; any other line as it is.
std::string unquoted(const std::string& line);

/// Where a kind of line is: outside of fences, formulas and links mean something.
bool is_inside(const std::vector<Fence>& fences, std::size_t line);

/// @throws PageError if the file cannot be read
Page read_page(const fs::path& file);
void write_page(const Page& page);

/// A page that is in no folder, with these lines.
Page page_of(const fs::path& file, const std::string& text);

/// All fences in order.
/// @throws PageError if one is not closed, or a snippet's comment has no fence below it
std::vector<Fence> fences_of(const Page& page);

/// The lines between the two fences.
std::string content_of(const Page& page, const Fence& fence);

/// "file:line: ", as every mistake begins. @param line from 0
std::string at(const Page& page, std::size_t line);

[[noreturn]] void fail(const Page& page, std::size_t line, const std::string& what);

/// The text without blanks around it.
std::string trimmed(const std::string& text);

/// The text without code spans: `` `a $x$` `` is no formula.
std::string without_code_spans(const std::string& line);

}  // namespace tumble::book
