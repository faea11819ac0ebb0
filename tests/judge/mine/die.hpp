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

/// The same impacts by the library.
struct DieTruth {
  std::vector<double> t;            ///< [s]
  std::vector<double> energy_left;  ///< after each, as a part of that at the start
  std::vector<double> grown;  ///< by how much t changed so far at most if the die starts higher by
                              ///< the tolerance [s]
  std::int64_t queries = 0;   ///< of the distance
  double seconds = 0;         ///< that it took
};

struct DieResult {
  DieQuestion question;
  DieTruth truth;
  std::optional<Timed<DieAnswer>> own;
  std::string failure = {};  ///< why there are no impacts

  /// By how much an impact comes later than the true one [s].
  double late(std::size_t impact) const;
  /// What is left of the energy after an impact, as a part of that at the start.
  double energy_left(std::size_t impact) const;
  /// The first impact that is missing, or further off than an error of the tolerance can have
  /// grown.
  std::optional<std::size_t> first_wrong() const;
  bool right() const;
  DieLaws laws() const;
};

/// Drops it.
DieResult die_of(const WorkerProgram& program);

}  // namespace tumble::judge::mine
