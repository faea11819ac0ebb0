#pragma once
/// @file
/// A part of a class that one machine of several grades. Which part a student is in follows from
/// the name alone: it is the same whenever and wherever it is asked, and nobody who comes or goes
/// moves another.

#include <cstddef>
#include <string>

namespace tumble::judge {

/// 3/10: the third of ten parts of about the same size.
struct Shard {
  std::size_t number = 1;
  std::size_t of = 1;

  bool operator==(const Shard&) const = default;
};

/// "3/10"
/// @throws std::invalid_argument if it is none
Shard shard_in(const std::string& text);
std::string name_of(const Shard& shard);

/// The number of the part that a student is in: with h = FNV-1a, 64 bits, of the bytes of the name,
/// it is ((h xor (h >> 32)) mod of) + 1.
std::size_t shard_number(const std::string& student, std::size_t of);

inline bool holds(const Shard& shard, const std::string& student) {
  return shard_number(student, shard.of) == shard.number;
}

}  // namespace tumble::judge
