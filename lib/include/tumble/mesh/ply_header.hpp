#pragma once
/// @file
/// The header of a PLY file: what elements there are, and what each is made of.
///
/// Source: G. Turk, The PLY polygon file format, Stanford 1994; the type names with sizes are those
/// of later programs.

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tumble/mesh/parse_number.hpp"
#include "tumble/mesh/text_scanner.hpp"

namespace tumble::detail {

enum class PlyFormat { ascii, little_endian, big_endian };

/// A scalar type; integers are all before floats.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct PlyTypeName {
  std::string_view name, name_with_size;
  std::size_t size;  ///< [bytes]
  double min, max;   ///< of an integer type
};

inline constexpr std::array<PlyTypeName, 8> ply_types = {
    {{"char", "int8", 1, -128, 127},
     {"uchar", "uint8", 1, 0, 255},
     {"short", "int16", 2, -32768, 32767},
     {"ushort", "uint16", 2, 0, 65535},
     {"int", "int32", 4, -2147483648.0, 2147483647},
     {"uint", "uint32", 4, 0, 4294967295},
     {"float", "float32", 4, 0, 0},
     {"double", "float64", 8, 0, 0}}};

inline const PlyTypeName& about(PlyType type) { return ply_types[static_cast<std::size_t>(type)]; }
inline bool is_integer(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
  std::string name;
  PlyType type;                       ///< of the value, or of each value of a list
  std::optional<PlyType> count = {};  ///< of a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::int64_t count;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
};

/// Reads the header line by line, from `ply` to `end_header`.
class PlyHeaderReader {
 public:
  explicit PlyHeaderReader(TextScanner& text) : text_(text) {}

  /// Leaves the text at the first byte after the header.
  PlyHeader read() {
    expect("ply");
    carriage_return_alone_ =
        text_.bytes_left() > 1 && text_.at()[0] == '\r' && text_.at()[1] != '\n';
    do {
      text_.next_line();
    } while (read_line());
    end_last_line();
    return std::move(header_);
  }

 private:
  /// Lines without a word and comments may be anywhere; the format is before the elements.
  /// @return whether more lines belong to the header
  bool read_line() {
    if (text_.at_end()) text_.refuse("the text ends where 'end_header' should be");
    const std::string_view keyword = text_.next_word();
    if (keyword.empty() || keyword == "comment" || keyword == "obj_info") return true;
    if ((keyword == "format") == has_format_)
      text_.refuse("'", shown(keyword), "' where ",
                   has_format_ ? "the elements should be" : "'format …' should be");
    if (keyword == "end_header") return false;
    if (keyword == "format")
      read_format();
    else if (keyword == "element")
      read_element();
    else if (keyword == "property")
      read_property();
    else
      text_.refuse("'", shown(keyword), "' is not a keyword of a PLY header");
    return true;
  }

  void read_format() {
    constexpr std::array<std::string_view, 3> names = {"ascii", "binary_little_endian",
                                                       "binary_big_endian"};
    const std::string_view word = text_.next_word();
    const auto place = std::find(names.begin(), names.end(), word) - names.begin();
    if (place == std::ssize(names)) text_.refuse("'", shown(word), "' is not a format of PLY");
    header_.format = static_cast<PlyFormat>(place);
    has_format_ = true;
    expect("1.0");
  }

  void read_element() {
    std::string name(text_.next_word());
    const std::string_view word = text_.next_word();
    const Parsed<std::int64_t> count = parse_integer(word.data(), word.data() + word.size());
    if (word.empty() || count.end != word.data() + word.size() || count.value < 0)
      text_.refuse("'", shown(word), "' is not a number of elements");
    for (const PlyElement& element : header_.elements)
      if (element.name == name) text_.refuse("a second element '", shown(name), "'");
    expect_line_end();
    header_.elements.push_back({std::move(name), count.value, {}});
  }

  void read_property() {
    if (header_.elements.empty()) text_.refuse("a property before the first element");
    PlyProperty property = read_type();
    property.name = text_.next_word();
    if (property.name.empty()) text_.refuse("a property without a name");
    expect_line_end();
    std::vector<PlyProperty>& all = header_.elements.back().properties;
    for (const PlyProperty& other : all)
      if (other.name == property.name)
        text_.refuse("a second property '", shown(property.name), "' of one element");
    all.push_back(std::move(property));
  }

  PlyProperty read_type() {
    const std::string_view word = text_.next_word();
    if (word != "list") return {"", type_of(word)};
    const PlyType count = type_of(text_.next_word());
    return {"", type_of(text_.next_word()), count};
  }

  PlyType type_of(std::string_view word) const {
    for (std::size_t i = 0; i < ply_types.size(); ++i)
      if (word == ply_types[i].name || word == ply_types[i].name_with_size)
        return static_cast<PlyType>(i);
    text_.refuse("'", shown(word), "' is not a type of PLY");
  }

  void expect(std::string_view expected) {
    const std::string_view word = text_.next_word();
    if (word != expected) text_.refuse("'", shown(word), "' where '", expected, "' should be");
    expect_line_end();
  }

  void expect_line_end() {
    const std::string_view word = text_.next_word();
    if (!word.empty()) text_.refuse("'", shown(word), "' where the line should end");
  }

  /// After a \r alone, a byte that looks like \n is a number's.
  void end_last_line() {
    expect_line_end();
    const bool alone = carriage_return_alone_ && header_.format != PlyFormat::ascii;
    if (alone && !text_.at_end())
      text_.move_to(text_.at() + 1);
    else
      text_.next_line();
  }

  TextScanner& text_;
  PlyHeader header_;
  bool has_format_ = false;
  bool carriage_return_alone_ = false;  ///< ends the lines
};

}  // namespace tumble::detail
