#pragma once
/// @file
/// JSON that a person has written: what the format leaves open is refused, for it is a slip.

#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "tumble/core/require.hpp"

namespace tumble::support {

/// The value of a document in which no { … } has a key twice: all but the last would be lost.
/// @param name of the file, for messages
/// @throws std::invalid_argument if it is none, and where
inline nlohmann::json parsed_json(const std::string& text, const std::string& name) {
  using Json = nlohmann::json;
  struct Open {  // { … } that has not ended yet
    std::string name;
    std::set<std::string> keys;
    std::string last;
  };
  std::vector<Open> all;
  const auto each_key_once = [&](int, Json::parse_event_t event, Json& value) {
    if (event == Json::parse_event_t::object_start)
      all.push_back({all.empty() ? name : all.back().name + "." + all.back().last, {}, {}});
    if (event == Json::parse_event_t::object_end) all.pop_back();
    if (event != Json::parse_event_t::key) return true;
    all.back().last = value.get<std::string>();
    require(all.back().keys.insert(all.back().last).second, all.back().name, " has ", value.dump(),
            " twice: which one counts?");
    return true;
  };
  try {
    return Json::parse(text, each_key_once);
  } catch (const Json::exception& error) {
    throw std::invalid_argument(name + " is no JSON: " + error.what());
  }
}

}  // namespace tumble::support
