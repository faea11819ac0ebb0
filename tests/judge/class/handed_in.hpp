#pragma once
/// @file
/// When a student has handed in, as far as a platform or a roster says something that can be true.

#include <optional>
#include <string>

#include "judge/class/moment.hpp"

namespace tumble::judge {

struct HandedIn {
  std::optional<Moment> when;
  std::string doubt;  ///< why what is said is no time: "cannot be read"; empty if nothing is said
};

/// A time before 2000 is a clock that was never set, or a platform's zero; one that is still to
/// come is a clock that is wrong. Nobody is late by those.
/// @param zone ahead of UTC [s], for a time that does not name its own
/// @param now  by this machine
HandedIn handed_in(const std::string& said, std::int64_t zone, Moment now);
/// The same, now.
HandedIn handed_in(const std::string& said, std::int64_t zone);

}  // namespace tumble::judge
