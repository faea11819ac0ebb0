#pragma once
/// @file
/// How far a long command is, and how long it will take: one line on stderr that is written over on
/// a terminal, and a new one now and then elsewhere.

#include <chrono>
#include <cstddef>
#include <string>

namespace tumble::judge {

class ProgressLine {
 public:
  /// @param of   how many parts there are
  /// @param what what they are, "units"
  ProgressLine(std::size_t of, std::string what);
  ~ProgressLine();
  /// One part is done.
  void tick();
  /// Takes the line away, so that something else can be printed.
  void clear() const;

 private:
  void print() const;
  double seconds() const;

  std::size_t done_ = 0, of_;
  std::string what_;
  bool terminal_;
  std::chrono::steady_clock::time_point start_, printed_;
};

/// "3 s", "12 min", "2 h 5 min".
std::string duration_text(double seconds);

}  // namespace tumble::judge
