#pragma once
/// @file
/// Reads a table that a platform or a spreadsheet has written.
///
/// Source: RFC 4180; what Excel does besides.

#include <optional>
#include <string>
#include <vector>

namespace tumble::judge {

struct CsvTable {
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;  ///< each as long as the header

  /// The number of the first column with one of these names, whatever their case.
  std::optional<std::size_t> column(const std::vector<std::string>& names) const;
  /// The text, with commas.
  std::string text() const;
};

/// @param bytes UTF-8 or UTF-16; fields between commas, semicolons or tabs
/// @param name  for messages
/// @throws std::invalid_argument naming the line of a quote that is not closed, or of a row that is
///         longer than the header
CsvTable read_csv(const std::string& bytes, const std::string& name);

/// Somebody else's text, which a spreadsheet must not take for a formula: with an apostrophe before
/// it where it would.
std::string without_formula(const std::string& text);

/// The same as a field, quoted where needed.
std::string foreign_field(const std::string& text);

}  // namespace tumble::judge
