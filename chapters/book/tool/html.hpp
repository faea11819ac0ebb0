#pragma once
/// @file
/// Pieces of HTML that the site has beside what Doxygen makes.

#include <filesystem>
#include <string>

namespace tumble::book {

/// One block of HTML in one line: Doxygen passes it on as it is.
std::string html_block(const std::string& text);

/// A line of Markdown without links, as HTML: `code`, and formulas between \( and \), which the
/// page's script sets.
std::string inline_html(const std::string& markdown);

/// `<a href="address">text</a>`; the text is HTML.
std::string link_html(const std::string& address, const std::string& text);

/// @throws PageError if the file cannot be read
std::string text_of(const std::filesystem::path& file);

/// @throws PageError if the file cannot be written
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace tumble::book
