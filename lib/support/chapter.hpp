#pragma once
/// @file
/// What every chapter's program has in common: named tables for the terminal and the page, named
/// figures for the page, and the same options.

#include <functional>
#include <string>
#include <vector>

#include "support/moving_figure.hpp"
#include "support/table.hpp"

namespace tumble::support {

class Chapter {
 public:
  /// @param folder the chapter's name, as in chapters/03_rotation_matrices
  /// @param title  what the program shows, in a sentence
  Chapter(std::string folder, std::string title);

  /// A table with the heading under which it is printed; the page shows it by its name.
  void table(const std::string& name, const std::string& heading, std::function<Table()> make);
  /// A table of times: other numbers on every machine and in every run.
  void measured(const std::string& name, const std::string& heading, std::function<Table()> make);
  /// An SVG document; the page shows NAME.svg.
  void figure(const std::string& name, std::function<std::string()> make);
  /// One that a reader can move; the page shows how it starts.
  void figure(const MovingFigure& moving);

  /// Without options: prints all tables, writes all figures and tables (as CSV) into a folder.
  /// `--only NAME` prints one table without its heading, `--figures DIR` writes the figures only;
  /// `--figure NAME` prints one as SVG, a moving one with `--set CONTROL=VALUE`.
  /// @return the exit status for main
  int run(int argc, char** argv) const;

 private:
  struct NamedTable {
    std::string name, heading;
    std::function<Table()> make;
  };
  struct NamedFigure {
    std::string name;
    std::function<std::string()> make;
    const MovingFigure* moving = nullptr;
  };
  void print_figure(const std::string& name, const std::vector<std::string>& set) const;
  void print_only(const std::string& name) const;
  void write_figures(const std::string& folder) const;
  void show_all(const std::string& folder) const;

  std::string folder_, title_;
  std::vector<NamedTable> tables_;
  std::vector<NamedFigure> figures_;
};

}  // namespace tumble::support
