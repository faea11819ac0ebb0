#pragma once
/// @file
/// Binary numbers in memory, read one after the other.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "tumble/core/require.hpp"

namespace tumble::detail {

/// Which byte of a number comes first.
enum class ByteOrder { little, big };

/// An unsigned integer of some bytes.
template <class Unsigned>
Unsigned load(const char* at, ByteOrder order) {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof(Unsigned); ++i) {
    const std::size_t place = order == ByteOrder::little ? i : sizeof(Unsigned) - 1 - i;
    const auto byte = static_cast<unsigned char>(at[i]);
    value = static_cast<Unsigned>(value | (Unsigned{byte} << (8 * place)));
  }
  return value;
}

class ByteScanner {
 public:
  ByteScanner(std::string_view bytes, std::size_t at, std::string_view name)
      : bytes_(bytes), at_(at), name_(name) {}

  std::size_t at() const { return at_; }  ///< the byte that is read next, from 0
  std::size_t bytes_left() const { return bytes_.size() - at_; }

  /// @param count no more than are left
  void skip(std::size_t count) { at_ += count; }

  /// The next unsigned integer; at least its bytes are left.
  template <class Unsigned>
  Unsigned next(ByteOrder order) {
    const auto value = load<Unsigned>(bytes_.data() + at_, order);
    at_ += sizeof(Unsigned);
    return value;
  }

  float next_float(ByteOrder order) { return std::bit_cast<float>(next<std::uint32_t>(order)); }
  double next_double(ByteOrder order) { return std::bit_cast<double>(next<std::uint64_t>(order)); }

  /// Refuses the file because of what begins at a byte.
  /// @throws std::invalid_argument naming the byte, from 0
  template <class... Parts>
  [[noreturn]] void refuse(std::size_t at, const Parts&... message) const {
    detail::refuse(name_, ", byte ", at, ": ", message...);
  }

 private:
  std::string_view bytes_;
  std::size_t at_;
  std::string_view name_;
};

}  // namespace tumble::detail
