#pragma once
/// @file
/// Tables that programs print in columns, as tables of HTML.

#include <string>

namespace tumble::book {

/// Reads a table whose second line is a rule of ─ over each column. A column of numbers is set
/// flush right, one of text flush left.
/// @return empty if the text is no such table
std::string number_table_html(const std::string& text);

}  // namespace tumble::book
