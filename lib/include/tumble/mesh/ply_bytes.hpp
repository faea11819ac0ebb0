#pragma once
/// @file
/// The values of a binary PLY file, without anything between them.

#include <string_view>

#include "tumble/mesh/byte_scanner.hpp"
#include "tumble/mesh/ply_header.hpp"

namespace tumble::detail {

/// Gives the values one after the other; PlyText does the same for ASCII files.
class PlyBytes {
 public:
  /// @param begin of the values: the byte after the header
  PlyBytes(std::string_view file, std::size_t begin, ByteOrder order, std::string_view name)
      : bytes_(file, begin, name), order_(order) {}

  /// Refuses an element that cannot be there as often as the header says.
  void require_room(const PlyElement& element) const {
    std::int64_t size = 0;  // with empty lists
    for (const PlyProperty& property : element.properties)
      size += static_cast<std::int64_t>(about(property.count.value_or(property.type)).size);
    if (element.count > static_cast<std::int64_t>(bytes_.bytes_left()) / size)
      bytes_.refuse(bytes_.at(), "the header announces ", element.count, " elements '",
                    shown(element.name), "', but only ", bytes_.bytes_left(), " bytes follow");
  }

  void begin(const PlyElement& element, std::int64_t index) {
    element_ = &element;
    number_ = index + 1;
    begin_ = bytes_.at();
  }

  void end() {}

  double next(const PlyProperty& property, PlyType type) {
    require_values(property, type, 1);
    switch (type) {
      case PlyType::int8:
        return static_cast<std::int8_t>(bytes_.next<std::uint8_t>(order_));
      case PlyType::uint8:
        return bytes_.next<std::uint8_t>(order_);
      case PlyType::int16:
        return static_cast<std::int16_t>(bytes_.next<std::uint16_t>(order_));
      case PlyType::uint16:
        return bytes_.next<std::uint16_t>(order_);
      case PlyType::int32:
        return static_cast<std::int32_t>(bytes_.next<std::uint32_t>(order_));
      case PlyType::uint32:
        return bytes_.next<std::uint32_t>(order_);
      case PlyType::float32:
        return double{bytes_.next_float(order_)};
      default:
        return bytes_.next_double(order_);
    }
  }

  void skip(const PlyProperty& property, PlyType type, std::int64_t count) {
    require_values(property, type, count);
    bytes_.skip(static_cast<std::size_t>(count) * about(type).size);
  }

  void require_end() const {
    if (bytes_.bytes_left() > 0)
      bytes_.refuse(bytes_.at(), bytes_.bytes_left(), " bytes are left after the last element");
  }

  /// Names the byte where the element begins.
  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... message) const {
    bytes_.refuse(begin_, shown(element_->name), " #", number_, ' ', message...);
  }

 private:
  void require_values(const PlyProperty& property, PlyType type, std::int64_t count) const {
    if (count > static_cast<std::int64_t>(bytes_.bytes_left() / about(type).size))
      refuse("has ", count, " values for '", shown(property.name), "', but the file ends after ",
             bytes_.bytes_left(), " bytes");
  }

  ByteScanner bytes_;
  ByteOrder order_;
  const PlyElement* element_ = nullptr;
  std::int64_t number_ = 0;
  std::size_t begin_ = 0;  ///< of the element
};

}  // namespace tumble::detail
