#pragma once
/// @file
/// JSON that a person has written: what the format leaves open is refused, for it is a slip.

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/json_fault.hpp"
#include "tumble/core/require.hpp"

namespace tumble::support {

/// "line 3, column 7" of the byte with this number, from 1.
inline std::string line_and_column(const std::string& text, std::size_t byte) {
  const std::string before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t end = before.rfind('\n');
  const std::size_t column = before.size() - (end == std::string::npos ? 0 : end + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

/// What the parser expected, without its own names for things.
inline std::string what_was_expected(const std::string& what) {
  constexpr std::array<std::array<std::string_view, 2>, 7> plain{{
      {"invalid literal",
       "JSON has no such word: it knows true, false, null and numbers, and a text has quotation "
       "marks"},
      {"control character",
       "a text holds a raw control character: write \\t for a tab, and \\n "
       "where a line ends"},
      {"surrogate",
       "a text holds half of a character, \\ud800 to \\udfff: write both halves one "
       "after the other, or the character itself"},
      {"ill-formed UTF-8", "a text is not UTF-8: save the file as UTF-8"},
      {"forbidden character after backslash",
       "a text holds a \\ before a character that needs none: write \\\\ for a \\ itself"},
      {"'\\u' must be followed", "a text holds a \\u without four hexadecimal digits behind it"},
      {"missing closing quote", "a text has no quotation mark at its end"},
  }};
  const std::string of_library = what.substr(0, what.find("; last read"));  // no text of the file
  for (const auto& [sign, words] : plain)
    if (of_library.find(sign) != std::string::npos) return std::string(words);
  const std::size_t dash = what.find(" - "), bracket = what.find("] ");
  if (dash != std::string::npos) return what.substr(dash + 3);
  return bracket != std::string::npos ? what.substr(bracket + 2) : what;
}

/// A { … } or a [ … ] that has not ended yet.
struct OpenPlace {
  std::string name;
  bool is_list;
  std::set<std::string> keys = {};
  std::string last = {};  ///< key
  int count = 0;          ///< of the elements that have begun

  /// Of what begins inside.
  std::string name_of_next() {
    return name + (is_list ? "[" + std::to_string(count++) + "]" : "." + last);
  }
};

/// The value of a document in which no { … } has a key twice: all but the last would be lost.
/// @param name of the file, for messages
/// @throws std::invalid_argument if it is none, and where; and if it is nested too deep: a walk
///         through it would run out of stack
inline nlohmann::json parsed_json(const std::string& text, const std::string& name) {
  using Json = nlohmann::json;
  std::vector<OpenPlace> all;
  constexpr int deepest = 64;  // nobody writes more by hand
  const auto each_key_once = [&](int depth, Json::parse_event_t event, Json& value) {
    require(depth < deepest, name, " is nested deeper than ", deepest,
            ": it has too many [ or { in each other");
    using Event = Json::parse_event_t;
    const bool is_list = event == Event::array_start;
    if (is_list || event == Event::object_start)
      all.push_back({all.empty() ? name : all.back().name_of_next(), is_list});
    if (event == Event::array_end || event == Event::object_end) all.pop_back();
    if (event == Event::value && !all.empty()) all.back().name_of_next();
    if (event != Event::key) return true;
    all.back().last = value.get<std::string>();
    require(all.back().keys.insert(all.back().last).second, all.back().name, " has ", value.dump(),
            " twice: which one counts?");
    return true;
  };
  try {
    return Json::parse(text, each_key_once);
  } catch (const Json::parse_error& error) {
    throw std::invalid_argument(name + " is not valid JSON: " + line_and_column(text, error.byte) +
                                ": " + what_was_expected(error.what()));
  } catch (const Json::out_of_range&) {
    const FirstFault fault = first_fault(text);
    throw std::invalid_argument(name + ", " + line_and_column(text, fault.byte) + ": the number " +
                                fault.token + " is too large: a double ends at 1.8e308");
  }
}

}  // namespace tumble::support
