#pragma once
/// @file
/// Results fit the terminal that shows them. In files and pipes they stay as they are.

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <string>

#include "support/printable.hpp"
#include "support/table.hpp"
#include "support/wrapped.hpp"

namespace tumble::support {

/// Columns of the terminal that shows stdout; nothing if stdout is a file or a pipe.
inline std::optional<std::size_t> terminal_width() {
  if (isatty(STDOUT_FILENO) != 1) return {};
  const char* columns = std::getenv("COLUMNS");
  if (const int given = columns == nullptr ? 0 : std::atoi(columns); given > 0)
    return static_cast<std::size_t>(given);
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return {};
  return size.ws_col;
}

/// A line, broken between words where the terminal is narrower.
inline std::string fitted(const std::string& line) {
  const auto width = terminal_width();
  const std::string shown = printable(line);
  return width && characters(shown) > *width ? wrapped(shown, *width, 2) : shown;
}

/// A table, stacked where the terminal is narrower.
inline std::string fitted(const Table& table) {
  const auto width = terminal_width();
  return width ? table.text_within(*width) : table.text();
}

}  // namespace tumble::support
