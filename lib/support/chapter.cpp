#include "support/chapter.hpp"

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "support/command_line.hpp"
#include "support/terminal.hpp"
#include "support/text_file.hpp"

namespace tumble::support {

Chapter::Chapter(std::string folder, std::string title)
    : folder_(std::move(folder)), title_(std::move(title)) {}

void Chapter::table(const std::string& name, const std::string& heading,
                    std::function<Table()> make) {
  tables_.push_back({name, heading, std::move(make)});
}

void Chapter::measured(const std::string& name, const std::string& heading,
                       std::function<Table()> make) {
  table(name, heading + " (times of this machine)", std::move(make));
}

void Chapter::figure(const std::string& name, std::function<std::string()> make) {
  figures_.push_back({name, std::move(make)});
}

void Chapter::figure(const MovingFigure& moving) {
  const auto still = [&moving] { return moving.draw(start_of(moving)); };
  figures_.push_back({std::string(moving.name), still, &moving});
}

void Chapter::print_only(const std::string& name) const {
  std::string known;
  for (const NamedTable& each : tables_) {
    if (each.name == name) {
      std::cout << each.make().text();
      return;
    }
    known += " " + each.name;
  }
  throw std::invalid_argument(folder_ + " has no table '" + name + "'; there are:" + known);
}

void Chapter::print_figure(const std::string& name, const std::vector<std::string>& set) const {
  std::string known;
  for (const NamedFigure& each : figures_) {
    known += " " + each.name;
    if (each.name != name) continue;
    if (!each.moving && !set.empty())
      throw std::invalid_argument("nothing can be set in the figure '" + name + "'");
    std::cout << (each.moving ? each.moving->draw(settings_of(*each.moving, set)) : each.make());
    return;
  }
  throw std::invalid_argument(folder_ + " has no figure '" + name + "'; there are:" + known);
}

void Chapter::write_figures(const std::string& folder) const {
  for (const NamedFigure& each : figures_)
    write_text_and_folders(std::filesystem::path(folder) / (each.name + ".svg"), each.make());
}

void Chapter::show_all(const std::string& folder) const {
  std::cout << title_ << "\n";
  for (const NamedTable& each : tables_) {
    const Table table = each.make();
    std::cout << "\n" << each.heading << "\n\n" << fitted(table) << std::flush;
    write_text_and_folders(std::filesystem::path(folder) / (each.name + ".csv"), table.csv());
  }
  write_figures(folder);
  std::cout << "\nFigures and tables: " << folder << "\n";
}

int Chapter::run(int argc, char** argv) const {
  CLI::App app(title_, "./tumble chapter " + std::to_string(std::atoi(folder_.c_str())));
  std::string only, figures, figure;
  std::vector<std::string> set;
  std::string out = "build/chapters/" + folder_;
  app.add_option("--only", only, "print one table, by its name, and nothing else");
  app.add_option("--figure", figure, "print one figure as SVG, by its name, and nothing else");
  app.add_option("--set", set, "CONTROL=VALUE: a setting of a figure that can be moved")
      ->needs("--figure");
  app.add_option("--figures", figures, "write the figures into this folder, and nothing else");
  app.add_option("--out", out, "folder for figures (SVG) and tables (CSV)")->capture_default_str();
  return run_command_line(app, argc, argv, [&] {
    if (app.count("--only") > 0)
      print_only(only);
    else if (app.count("--figure") > 0)
      print_figure(figure, set);
    else if (app.count("--figures") > 0)
      write_figures(figures);
    else
      show_all(out);
    return exit_status::achieved;
  });
}

}  // namespace tumble::support
