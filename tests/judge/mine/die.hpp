#pragma once
/// @file
/// A die that falls onto a table without friction, by a student's functions: how late its impacts
/// come, and which laws they break.

#include <optional>
#include <string>
#include <vector>

#include "judge/mine/own_engine.hpp"

namespace tumble::judge::mine {

/// By how much the impacts break what has to stay at most, up to the first wrong one.
struct DieLaws {
  double height = 0;    ///< of the lowest corner at an impact, from the table [m]
  double sideways = 0;  ///< of what a table without friction can't change: P_x, P_y and L_z, as
                        ///< parts of |P| and |L|
  double energy = 0;    ///< by which it rises in an impact, as a part of that at the start
};

/// An impact by the library.
struct TrueImpact {
  double t;            ///< [s]
  double energy_left;  ///< after it, as a part of that at the start
  double grown;        ///< by how much t has changed so far at most if the die starts higher by the
                       ///< tolerance [s]
  double energy_grown;  ///< and energy_left
};

struct DieTruth {
  std::vector<TrueImpact> impacts;
  std::int64_t queries = 0;  ///< of the distance
};

/// The impacts of a student's die, beside the true ones.
struct DieResult {
  DieQuestion question;
  DieTruth truth;
  std::optional<DieAnswer> own;
  std::string failure = {};  ///< why there is no answer

  /// How many impacts both have.
  std::size_t common() const;
  /// By how much an impact comes later than the true one [s].
  double late(std::size_t impact) const;
  /// What is left of the energy after an impact, as a part of that at the start. A die that lies on
  /// the table has none by its height.
  double energy_left(std::size_t impact) const;
  /// The first impact that is missing or too far off: by 100 times what an error of the tolerance
  /// has grown to, as each impact is found to the tolerance; or by so much that it could be the
  /// next one, or the one before.
  std::optional<std::size_t> first_wrong() const;
  bool right() const { return own && !first_wrong(); }
  DieLaws laws() const;
};

/// Drops it.
DieResult die_of(const WorkerProgram& program);

}  // namespace tumble::judge::mine
