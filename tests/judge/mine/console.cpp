#include <algorithm>
#include <cmath>
#include <ostream>
#include <sstream>

#include "judge/mine/report.hpp"
#include "judge/verdict/number_text.hpp"
#include "support/table.hpp"
#include "support/terminal.hpp"
#include "support/wrapped.hpp"

namespace tumble::judge::mine {

namespace {

using support::duration;
using support::error_number;
using support::number;
using support::Table;

std::string shown(const Course& course, const fs::path& file) {
  const std::string inside = fs::relative(file, course.root).string();
  return inside.starts_with("..") ? file.string() : inside;
}

/// The first lines, indented.
std::string indented(const std::string& text, std::size_t most_lines) {
  std::istringstream in(printable(text));
  std::string result;
  std::size_t lines = 0;
  for (std::string line; std::getline(in, line) && lines < most_lines; ++lines)
    result += "          " + line + "\n";
  return result;
}

std::string order_text(double order) { return std::isfinite(order) ? number(order, 2) : "–"; }

void add_row(Table& table, const std::string& name, const Point& point, const std::string& order) {
  const bool steps = point.steps > 0;
  table.add({name, steps ? std::to_string(point.steps) : "none",
             steps ? std::to_string(point.evaluations) : "none", error_number(point.error), order,
             steps ? number(1e6 * point.seconds / point.steps) : "–", duration(point.seconds)});
}

/// The first, the middle and the last point of a curve.
void add_curve(Table& table, const EngineBuild& build, const OwnCurve& own) {
  const std::vector<Point>& points = own.curve.points;
  const std::string name = owner_of(build, number_of(own.method)) + " " + own.curve.name;
  if (points.empty()) table.add({name, "–", "–", "no answer", "–", "–", "–"});
  for (std::size_t i = 0; i < points.size(); ++i)
    if (i == 0 || i == points.size() / 2 || i + 1 == points.size())
      add_row(table, name, points[i], i + 1 == points.size() ? order_text(own.order) : "");
}

std::string table_of(const EngineBuild& build, const ProblemResult& result) {
  Table table({"method", "steps", "evaluations", "error at the end [rad]", "order", "µs per step",
               "total time"});
  for (const OwnCurve& own : result.own) add_curve(table, build, own);
  if (result.closed_form)
    add_row(table, owner_of(build, closed_form_unit) + " " + result.closed_form->name,
            result.closed_form->points.front(), "");
  for (const Curve& curve : result.library)
    add_row(table, "library's " + curve.name, curve.points.back(), "");
  return support::fitted(table);
}

/// A line for each: what is not there, and where it would be.
std::string list_of(const Course& course, const std::vector<Part>& missing) {
  std::size_t name = 0, what = 0;
  for (const Part& part : missing) {
    name = std::max(name, part.unit.name.size());
    what = std::max(what, part.missing.size());
  }
  std::string lines;
  for (const Part& part : missing)
    lines += "  " + support::padded(part.unit.number, 6) +
             support::padded(part.unit.name, name + 3) + support::padded(part.missing, what + 3) +
             shown(course, part.source) + "\n";
  return lines;
}

/// What the compiler says about each.
std::string details_of(const std::vector<Part>& missing) {
  std::string lines;
  for (const Part& part : missing)
    if (!part.detail.empty())
      lines += "      " + part.unit.number + " " + part.unit.name + ", " + part.missing + ":\n" +
               indented(part.detail, 4);
  return lines;
}

std::string table_of(const DieResult& die) {
  Table table({"impact", "at [s]", "late by [s]", "the tolerance has grown to [s]", "energy left"});
  for (std::size_t i = 0; i < die.common(); ++i)
    table.add({std::to_string(i + 1), number(die.own->impacts[i].t, 6), error_number(die.late(i)),
               error_number(die.truth.impacts[i].grown),
               number(100 * die.energy_left(i), 3) + " %"});
  return support::fitted(table);
}

std::string about_die(const DieResult& die) {
  std::string text =
      "A die falls onto a table without friction, with e = " + number(die.question.e) + ".\n";
  if (die.common() == 0) return text;
  text += "A contact begins at a gap of " + error_number(die.question.tolerance) +
          " m, so the times are off, and each impact makes the error larger:\n\n" + table_of(die);
  if (!die.right()) return text;
  return text + "\nIt took " + std::to_string(die.own->queries) +
         " distances (11.2); the library, " + "which looks for the time in another way, takes " +
         std::to_string(die.truth.queries) + ".\n";
}

}  // namespace

std::string names_of(const std::vector<Part>& parts) {
  std::string names;
  for (const Part& part : parts)
    names += (names.empty() ? "" : ", ") + part.unit.number + " " + part.unit.name;
  return names;
}

std::string owner_of(const EngineBuild& build, const std::string& number) {
  for (const Part& part : build.parts)
    if (part.unit.number == number && !part.own()) return "solution's";
  return "your";
}

void print_missing(std::ostream& out, const Course& course, const EngineBuild& build) {
  const std::vector<Part> missing = build.missing();
  out << "An engine is made of " << build.parts.size() << " of the course's functions, and "
      << missing.size() << " of yours " << (missing.size() == 1 ? "is" : "are")
      << " not there yet:\n\n";
  out << list_of(course, missing) << "\n";
  out << details_of(missing);
  out << "  Next:  ./tumble check " << missing.front().unit.number
      << "        With ours in their place:  ./tumble mine --fill\n";
}

void print_parts(std::ostream& out, const EngineBuild& build) {
  const std::vector<Part> missing = build.missing();
  out << "An engine of " << build.parts.size() << " functions, ";
  if (missing.empty())
    out << "all of them yours.\n";
  else
    out << build.parts.size() - missing.size()
        << " of them yours. From the solutions: " << names_of(missing) << ".\n";
  for (const std::string& name : build.defined_twice)
    out << "Defined in more than one of your files: " << one_line(name)
        << ". Here the first one counts for all; helpers belong into an unnamed namespace.\n";
}

void print_measurement(std::ostream& out, const EngineBuild& build,
                       const Measurement& measurement) {
  for (const ProblemResult& result : measurement.problems) {
    out << "\nIn " << number(result.problem.duration) << " s: " << result.problem.sentence << ".\n";
    if (result.mass.own)
      out << "Mass, centre and inertia from its " << result.problem.mesh.face_count()
          << " faces: off by " << error_number(result.mass.error) << " of their size, in "
          << duration(result.mass.own->seconds) << ".\n";
    out << "\n" << table_of(build, result);
  }
  if (measurement.drift.own)
    out << "\nIn 128 midpoint steps the energy of the free T-handle strays from its first value E₀ "
           "by at most " +
               error_number(measurement.drift.own->largest) + " E₀, and by " +
               error_number(measurement.drift.own->trend) + " E₀ per second (10.3 energy_drift).\n";
  if (measurement.die) out << "\n" << about_die(*measurement.die);
}

void print_waiting(std::ostream& out, const Course& course, const std::vector<Part>& waiting) {
  out << "\nTo drop a die onto a table, we also need these functions of yours, which are not there "
         "yet:\n\n"
      << list_of(course, waiting) << details_of(waiting) << "\n  Next:  ./tumble check "
      << waiting.front().unit.number << "\n";
}

}  // namespace tumble::judge::mine
