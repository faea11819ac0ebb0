#include "judge/verdict/console.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ostream>
#include <sstream>

#include "judge/conversation/endings.hpp"
#include "judge/course/contract.hpp"
#include "judge/course/derivation.hpp"
#include "judge/spec/demand.hpp"
#include "judge/verdict/number_text.hpp"
#include "judge/verdict/typed_text.hpp"
#include "support/entry.hpp"
#include "support/wrapped.hpp"

namespace tumble::judge {

ConsoleStyle style_of_terminal() {
  const char* no_colour = std::getenv("NO_COLOR");
  return {.colour = isatty(STDOUT_FILENO) == 1 && !(no_colour && *no_colour)};
}

namespace {

enum class Colour { green = 32, red = 31, yellow = 33, bold = 1, dim = 2 };

std::string indented(const std::string& text, const std::string& by, std::size_t most_lines) {
  std::istringstream in(printable(text));
  std::string result;
  std::size_t lines = 0;
  for (std::string line; std::getline(in, line); ++lines) {
    if (lines == most_lines) return result + by + "…\n";
    result += by + line + "\n";
  }
  return result;
}

/// The text in lines of at most 100 characters, all but the first indented.
std::string wrapped(const std::string& text, std::size_t indent) {
  std::string result;
  for (const std::string& line : support::lines_of(text, 100 - indent))
    result += (result.empty() ? "" : "\n" + std::string(indent, ' ')) + line;
  return result;
}

std::string short_number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", x);
  return text;
}

/// Prints the verdict on one unit.
class Printer {
 public:
  Printer(std::ostream& out, const Course& course, const UnitResult& result,
          const ConsoleStyle& style)
      : out_(out),
        course_(course),
        result_(result),
        style_(style),
        declaration_(read_declaration(course, result.unit)),
        types_(course, result.unit) {}

  void print() {
    print_line(out_, result_, style_);
    if (!result_.judge_failure.empty())
      explain_judge_failure();
    else if (result_.build != BuildOutcome::built)
      explain_build();
    else if (result_.untouched())
      explain_untouched();
    else if (!result_.passed())
      explain_cases();
    if (!result_.why_no_place.empty())
      out_ << "  The line could not be looked for: " << one_line(result_.why_no_place) << "\n\n";
    print_luck();
    print_warnings();
  }

 private:
  /// The file that was judged: as in the course, or as it was given.
  std::string exercise() const {
    const fs::path inside = fs::relative(result_.source, course_.root);
    return inside.string().starts_with("..") ? result_.source.string() : inside.string();
  }
  std::string paint(const std::string& text, Colour colour) const {
    if (!style_.colour) return text;
    return "\033[" + std::to_string(static_cast<int>(colour)) + "m" + text + "\033[0m";
  }

  void explain_judge_failure() {
    out_ << "\n  The judge failed here: " << one_line(result_.judge_failure)
         << ".\n  This is not a verdict on your code. Try again; if it fails again, tell your "
            "instructor.\n\n";
  }

  // ── Not built ──

  void explain_build() {
    out_ << "\n";
    switch (result_.build) {
      case BuildOutcome::refused:
        out_ << "  " << one_line(result_.build_detail) << ".\n";
        if (!support::is_there(result_.source))
          out_ << "  The untouched exercise:  ./tumble reset " << result_.unit.number << "\n";
        break;
      case BuildOutcome::does_not_compile:
        out_ << "  The compiler does not accept " << exercise() << ":\n\n"
             << indented(result_.build_detail, "    ", 30);
        break;
      case BuildOutcome::forbidden_include:
        out_ << "  " << exercise() << " includes what an exercise may not see"
             << (result_.build_detail.empty() ? ".\n" : ":\n\n")
             << indented(result_.build_detail, "    ", 8)
             << "\n  An exercise has its contract, Eigen/Core and the standard library, and "
                "includes "
                "nothing else.\n";
        break;
      case BuildOutcome::assembly:
        out_ << "  " << exercise() << " contains assembler code. Write plain C++.\n";
        break;
      case BuildOutcome::too_expensive:
        out_ << "  The compiler did not finish with " << exercise()
             << " within its limits of time and memory.\n"
             << indented(result_.build_detail, "    ", 8);
        break;
      case BuildOutcome::wrong_signature:
        out_ << "  " << exercise()
             << " compiles, but does not define the function of its contract:\n\n"
             << indented(result_.build_detail, "    ", 16);
        break;
      case BuildOutcome::built:
        break;
    }
    out_ << "\n";
  }

  std::string relative(const fs::path& path) const {
    return fs::relative(path, course_.root).string();
  }

  void explain_untouched() {
    out_ << "\n  Nothing is written yet. Your task: " << declaration_.title << "\n\n"
         << indented(declaration_.signature, "    ", 8) << "\n  Write it in  " << exercise()
         << "   (its contract: " << relative(course_.contract(result_.unit)) << ")\n"
         << "  A hint:      ./tumble hint " << result_.unit.number << "\n\n";
  }

  // ── Cases ──

  void explain_cases() {
    out_ << "\n";
    bool explained = false;
    for (const CaseResult& result : result_.cases) {
      out_ << "  " << (result.passed() ? paint("✓", Colour::green) : paint("✗", Colour::red)) << " "
           << result.law;
      if (!result.passed() && result.finding->outcome != Outcome::wrong)
        out_ << paint("  [" + name_of(result.finding->outcome) + "]", Colour::red);
      out_ << "\n";
      if (result.passed() || (explained && !style_.every_case)) continue;
      explain(result);
      explained = true;
    }
    out_ << "\n";
  }

  void explain(const CaseResult& result) {
    const Finding& finding = *result.finding;
    out_ << "\n";
    if (finding.question) explain_question(*finding.question);
    if (finding.outcome == Outcome::wrong)
      explain_wrong_answer(finding);
    else
      out_ << sentence_about(finding) << "\n";
    if (!finding.place.empty())
      out_ << label(finding.outcome == Outcome::wrong ? "A sanitizer stops at" : "It happens at")
           << paint(one_line(finding.place), Colour::bold) << "\n";
    for (const Misconception& misconception : finding.misconceptions)
      explain_misconception(misconception);
    if (finding.outcome == Outcome::wrong && !names_section(finding))
      out_ << (finding.misconceptions.empty() ? "\n" : "")
           << where_to_read(derivation_of(course_, result_.unit));
    if (const std::string printed = printed_by_student(finding); !printed.empty())
      out_ << "\n      It printed:\n" << indented(printed, "        | ", 12);
    out_ << "\n      To run only this case:  "
         << paint("./tumble check " + result_.unit.number + "." + std::to_string(result.number) +
                      " --seed " + std::to_string(result_.seed),
                  Colour::bold)
         << "\n\n";
  }

  /// Without the assertion that ended the program, which is told already.
  static std::string printed_by_student(const Finding& finding) {
    if (finding.outcome != Outcome::crashed) return finding.printed;
    std::istringstream in(finding.printed);
    std::string kept;
    for (std::string line; std::getline(in, line);)
      if (!tells_an_assertion(line)) kept += line + "\n";
    return kept;
  }

  static constexpr std::size_t label_width = 24;
  static std::string label(const std::string& text) {
    return "      " + text +
           std::string(std::max<std::size_t>(label_width, text.size() + 7) - 6 - text.size(), ' ');
  }

  void explain_question(const Question& question) {
    std::string names;
    for (const std::string& name : declaration_.parameters)
      names += (names.empty() ? "" : ", ") + name;
    out_ << "      " << result_.unit.name << "(" << names << ") was called with\n";
    for (std::size_t i = 0; i < question.arguments.size(); ++i) {
      const std::string name =
          i < declaration_.parameters.size() ? declaration_.parameters[i] : "argument";
      const std::string type = i < declaration_.types.size() ? declaration_.types[i] : "";
      out_ << "        " << name << " = "
           << TypedText{types_, type, 17, name.size() + 11, {}}.of(question.arguments[i]) << "\n";
    }
    explain_evaluations(question);
  }

  void explain_evaluations(const Question& question) {
    if (question.evaluations == 0) return;
    out_ << "      Calls of the functions that it was given: " << question.evaluations;
    if (question.evaluations > question.first_evaluations.size()) out_ << ", the first of them";
    out_ << "\n";
    for (const Evaluation& each : question.first_evaluations) {
      const std::string call =
          name_of_function(question, each.function) + text_of(each.arguments, 9);
      out_ << "        " << call << " = " << text_of(each.result, 9, call.size() + 11) << "\n";
    }
  }

  /// The parameter that `function` came as.
  std::string name_of_function(const Question& question, FunctionId function) const {
    const std::size_t shown = std::min(question.arguments.size(), declaration_.parameters.size());
    for (std::size_t i = 0; i < shown; ++i) {
      const FunctionId* argument = question.arguments[i].as<FunctionId>();
      if (argument && *argument == function) return declaration_.parameters[i];
    }
    return "function";
  }

  /// "Your answer has 0 numbers; 3 are demanded", if it is so.
  static std::string difference_in_size(const Value& answer, const Value& demanded) {
    const List *a = answer.as<List>(), *d = demanded.as<List>();
    if (!a || !d || a->size() == d->size()) return {};
    return "It has " + std::to_string(a->size()) + (a->size() == 1 ? " entry" : " entries") +
           " where " + std::to_string(d->size()) + (d->size() == 1 ? " is" : " are") + " demanded.";
  }

  /// Nine, or all where the ninth does not show what is wrong.
  static int digits_that_show(const Finding& finding) {
    constexpr int few = 9, all = 17;
    const bool is_near =
        finding.demanded ? text_of(*finding.answer, few) == text_of(*finding.demanded, few)
                         : finding.missed < 1e-8 * std::fmax(1, largest_magnitude(*finding.answer));
    return is_near ? all : few;
  }

  void explain_wrong_answer(const Finding& finding) {
    if (!finding.answer) {
      out_ << "      " << one_line(finding.detail) << "\n";
      return;
    }
    TypedText text{types_, declaration_.result, digits_that_show(finding), label_width, {}};
    if (finding.demanded)
      text.marked =
          furthest_member(types_, declaration_.result, *finding.answer, *finding.demanded);
    out_ << label("Your answer") << text.of(*finding.answer) << "\n";
    text.marked.clear();
    if (finding.demanded) {
      out_ << label("Demanded") << text.of(*finding.demanded) << "\n";
      if (const std::string sizes = difference_in_size(*finding.answer, *finding.demanded);
          !sizes.empty())
        out_ << std::string(label_width, ' ') << sizes << "\n";
      if (const std::string first =
              hidden_difference(text, *finding.answer, *finding.demanded, finding.tolerance);
          !first.empty())
        out_ << label("First difference") << first << "\n";
      print_difference(finding);
    }
    if (!finding.detail.empty()) out_ << label("Demanded") << one_line(finding.detail) << "\n";
  }

  /// The largest between real numbers: that a word, an index or a count is another one shows.
  static double difference_of_reals(const Value& answer, const Value& demanded) {
    if (answer.as<double>()) return largest_difference(answer, demanded);
    const List *a = answer.as<List>(), *d = demanded.as<List>();
    double largest = 0;
    for (std::size_t i = 0; a && d && i < std::min(a->size(), d->size()); ++i)
      largest = worse(largest, difference_of_reals((*a)[i], (*d)[i]));
    return largest;
  }

  void print_difference(const Finding& finding) {
    const double apart = difference_of_reals(*finding.answer, *finding.demanded);
    if (!(apart > 0)) return;
    out_ << label("Largest difference") << short_number(apart)
         << (finding.tolerance > 0 ? " (allowed: " + short_number(finding.tolerance) + ")"
                                   : " (it must be exact)")
         << "\n";
  }

  static std::string sentence_about(const Finding& finding) {
    std::string detail = one_line(finding.detail);
    switch (finding.outcome) {
      case Outcome::not_implemented:
        return "      Your code throws NotImplemented here.";
      case Outcome::threw:
        return "      Your code threw an exception: " + detail;
      case Outcome::crashed:
        return "      Your code crashed: " + detail + ".";
      case Outcome::hung:
        return "      Your code did not answer: " + detail + ". A loop that never ends?";
      case Outcome::out_of_memory:
        return "      Your code asked for too much memory: " + detail +
               " is not allowed."
               "\n      A loop that keeps more and more, or one vector of a size that is far too "
               "large?";
      case Outcome::flooded:
        return "      Your code prints without end: " + detail + ".";
      case Outcome::exited:
        return "      Your code ended the program (" + detail + ") instead of returning an answer.";
      case Outcome::forbidden:
        return "      Your code " + detail +
               ".\n      An exercise computes: it has no files, no network, no threads and no "
               "other processes.";
      case Outcome::wrong_call:
        return "      Your code called a function that it got as an argument, in a way that is not "
               "allowed:\n"
               "      " +
               detail + ".";
      case Outcome::malformed:
        return "      What came back is not an answer: " + detail +
               ".\n      Only the value that your function returns counts.";
      case Outcome::not_run:
        return "      Not tried: " + detail + ".";
      case Outcome::wrong:
      case Outcome::passed:
        break;
    }
    return detail;
  }

  void explain_misconception(const Misconception& misconception) {
    out_ << "\n      " << paint("It looks like “" + misconception.name + "”.", Colour::yellow)
         << "\n      " << wrapped(misconception.sentence, 6) << "\n";
    out_ << where_to_read(misconception.section);
  }

  static bool names_section(const Finding& finding) {
    return std::any_of(finding.misconceptions.begin(), finding.misconceptions.end(),
                       [](const Misconception& each) { return !each.section.empty(); });
  }

  std::string where_to_read(const std::string& section) const {
    const fs::path page = course_.page(result_.unit);
    if (section.empty() || !fs::exists(page)) return {};
    return "      Read " + relative(page) + ", “" + section + "”.\n";
  }

  void print_luck() {
    if (!result_.lucky_variable.empty())
      out_
          << "\n  Your answers may be right by luck: the compiler sees that a variable may be used "
             "before it is set.\n    "
          << paint(one_line(result_.lucky_variable), Colour::yellow)
          << "\n  Give it a value where it is declared.\n\n";
    if (result_.lucky_place.empty()) return;
    out_ << "\n  Your answers are right by luck: they come from memory that is gone.\n    "
         << paint(result_.lucky_place, Colour::yellow)
         << "\n  An auto may hold an expression of Eigen, not its value. Write the type "
            "instead.\n\n";
  }

  void print_warnings() {
    if (result_.warnings.empty()) return;
    out_ << "  The compiler warns:\n\n" << indented(result_.warnings, "    ", 12) << "\n";
  }

  std::ostream& out_;
  const Course& course_;
  const UnitResult& result_;
  const ConsoleStyle& style_;
  Declaration declaration_;
  ContractTypes types_;
};

}  // namespace

void print_line(std::ostream& out, const UnitResult& result, const ConsoleStyle& style) {
  const bool passed = result.passed();
  const std::string mark = passed ? "✓" : result.untouched() ? "·" : "✗";
  const char* colour = passed ? "\033[32m" : result.untouched() ? "\033[2m" : "\033[31m";
  std::string words = result.summary();
  if (passed)
    words += ", all " + std::to_string(result.cases.size()) + " laws hold";
  else if (!result.cases.empty() && !result.untouched())
    words += ", " + std::to_string(result.passed_cases()) + " of " +
             std::to_string(result.cases.size()) + " laws hold";
  out << (style.colour ? colour : "") << mark << " " << result.unit.number << " "
      << result.unit.name << (style.colour ? "\033[0m" : "") << "  " << words;
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "  (%.2f s)", result.seconds);
  out << seconds << "\n";
}

void print_result(std::ostream& out, const Course& course, const UnitResult& result,
                  const ConsoleStyle& style) {
  Printer(out, course, result, style).print();
}

}  // namespace tumble::judge
