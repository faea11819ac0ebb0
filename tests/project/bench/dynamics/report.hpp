#pragma once
/// @file
/// What came out, as tables and figures.

#include "project/bench/dynamics/work_precision.hpp"
#include "support/plot.hpp"
#include "support/table.hpp"

namespace tumble::bench {

/// Each method's time to reach each mark, and its best error; ours first, then the others, the
/// fastest on top.
support::Table times_table(std::vector<Curve> curves);

/// At each mark our fastest method beside the fastest of the others.
support::Table ratio_table(const std::vector<Curve>& curves);

/// Error against time: of each software its best method, of ours all that are fastest at some mark.
support::Plot figure(const Problem& problem, const std::vector<Curve>& curves);

}  // namespace tumble::bench
