#pragma once
/// @file
/// What came out, as tables and figures.

#include "project/bench/speed_against_error.hpp"
#include "support/plot.hpp"
#include "support/table.hpp"

namespace tumble::bench {

/// Each method's time to reach each mark, its best error, and the setting for it; ours first, then
/// the others, the fastest on top.
support::Table times_table(std::vector<Curve> curves);

/// At each mark our fastest method beside the fastest of the others.
support::Table ratio_table(const std::vector<Curve>& curves);

/// What the setting of a method is called: 1e-09, or 1200 steps; none if it never got anywhere.
std::string setting_name(const Curve& curve);

/// Error against time: of each software its best method, of ours all that are fastest at some mark.
/// @param error what it is, and its unit
support::Plot figure(const std::string& title, const std::string& error,
                     const std::vector<Curve>& curves);

}  // namespace tumble::bench
