#pragma once
/// @file
/// Numbers positions while they come: equal ones get the same number.

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "tumble/core/types.hpp"

namespace tumble::detail {

/// A hash table of positions that are equal bit by bit, where −0 has become 0.
class VertexWelder {
 public:
  /// The number of this position: that of an equal one before it, or a new one.
  int number_of(const Vec3& position) {
    const Vec3 p = position + Vec3::Zero();  // −0 + 0 = 0
    if (2 * positions_.size() >= slots_.size()) grow();
    int& slot = slot_of(p);
    if (slot < 0) {
      slot = static_cast<int>(positions_.size());
      positions_.push_back(p);
    }
    return slot;
  }

  /// The positions by number.
  std::vector<Vec3> take_positions() { return std::move(positions_); }

 private:
  static std::size_t hash(const Vec3& p) {
    std::uint64_t h = 0;
    for (int k = 0; k < 3; ++k) {
      h = (h ^ std::bit_cast<std::uint64_t>(p[k])) * 0x9E3779B97F4A7C15u;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }

  /// Where the number of p is, or would be: −1.
  int& slot_of(const Vec3& p) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = hash(p) & mask;; i = (i + 1) & mask) {
      int& slot = slots_[i];
      if (slot < 0 || positions_[static_cast<std::size_t>(slot)] == p) return slot;
    }
  }

  void grow() {
    slots_.assign(slots_.empty() ? 1024 : 2 * slots_.size(), -1);
    for (std::size_t i = 0; i < positions_.size(); ++i)
      slot_of(positions_[i]) = static_cast<int>(i);
  }

  std::vector<Vec3> positions_;
  std::vector<int> slots_;  ///< a power of two of numbers, −1 where there is none
};

}  // namespace tumble::detail
