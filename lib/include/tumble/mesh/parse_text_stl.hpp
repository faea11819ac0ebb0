#pragma once
/// @file
/// ASCII STL in memory.
///
/// Source: 3D Systems, StereoLithography Interface Specification (1988), as in M. Burns, Automated
/// Fabrication (1993), section 6.5. Words are separated by any blanks and line ends; the name after
/// `solid` and `endsolid` is the rest of the line, or what comes before a facet in it. Files with
/// several solids are one mesh.

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string_view>
#include <utility>

#include "tumble/mesh/foreign_format.hpp"
#include "tumble/mesh/parse_number.hpp"
#include "tumble/mesh/polygon_mesh.hpp"
#include "tumble/mesh/text_scanner.hpp"
#include "tumble/mesh/vertex_welder.hpp"

namespace tumble::detail {

class StlTextReader {
 public:
  StlTextReader(std::string_view text, std::string_view name) : text_(text, name), name_(name) {}

  PolygonMesh read() {
    text_.skip_to_word();
    if (!next_is("solid"))
      text_.refuse("an ASCII STL file begins with 'solid', not with '", shown(text_.peek_word()),
                   "'", about_foreign_format({text_.at(), text_.bytes_left()}));
    for (; !text_.at_end(); text_.skip_to_word()) read_solid();
    require(mesh_.face_count() > 0, name_, ": no faces");
    mesh_.vertices = welder_.take_positions();
    return std::move(mesh_);
  }

 private:
  void read_solid() {
    expect("solid");
    skip_name("facet");
    for (text_.skip_to_word(); next_is("facet"); text_.skip_to_word()) read_facet();
    expect("endsolid");
    skip_name("solid");
  }

  /// The name is the rest of the line. Some programs write all in one line: there it ends at the
  /// last word `next` before a facet.
  void skip_name(std::string_view next) {
    TextScanner name = text_;
    const char *first = nullptr, *last = nullptr;
    for (auto word = name.next_word(); !word.empty(); word = name.next_word()) {
      if (!first) first = word.data();
      if (is_keyword(word, next)) last = word.data();
      if (last != nullptr && is_keyword(word, "facet") && begins_facet(name, word.data() == first))
        return text_.move_to(last);
    }
    text_.skip_to_line_end();
  }

  /// Whether what follows the word `facet` is a facet's, and not a name's: then a loop or a vertex
  /// comes before the next facet, whatever is wrong in it. Three numbers after `normal` are enough
  /// for a facet that has lost its loop, unless a name begins with them.
  static bool begins_facet(TextScanner after, bool is_first_word) {
    const auto next = [&after] {
      after.skip_to_word();
      return after.next_word();
    };
    if (!is_keyword(next(), "normal")) return false;
    int numbers = 0;
    bool only_numbers = true;
    std::string_view before;
    for (std::string_view word = next(); !word.empty(); before = std::exchange(word, next())) {
      only_numbers = only_numbers && is_number(word);
      if (only_numbers && ++numbers == 3 && !is_first_word) return true;
      if (is_keyword(before, "outer") && is_keyword(word, "loop")) return true;
      if (is_keyword(before, "vertex") && is_number(word)) return true;
      if (is_one_of(word, {"facet", "solid", "endsolid"})) return false;
    }
    return false;
  }

  static bool is_number(std::string_view word) {
    const char* end = word.data() + word.size();
    return parse_double(word.data(), end).end == end;
  }

  static bool is_one_of(std::string_view word, std::initializer_list<std::string_view> keywords) {
    return std::any_of(keywords.begin(), keywords.end(),
                       [=](std::string_view keyword) { return is_keyword(word, keyword); });
  }

  void read_facet() {
    expect("facet");
    expect("normal");
    for (int k = 0; k < 3; ++k) skip_normal();
    expect("outer");
    expect("loop");
    for (int k = 0; k < 3; ++k) mesh_.corners.push_back(read_vertex(k));
    text_.skip_to_word();
    if (next_is("vertex")) refuse("has more than 3 vertices");
    expect("endloop");
    expect("endfacet");
    if (mesh_.corners.size() > std::numeric_limits<int>::max())
      refuse("is one too many: a mesh has at most 2147483647 corners");
    mesh_.first_corner.push_back(static_cast<int>(mesh_.corners.size()));
  }

  int read_vertex(int number) {
    text_.skip_to_word();
    if (!next_is("vertex") && next_is("endloop")) refuse("has ", number, " vertices, and needs 3");
    expect("vertex");
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = read_coordinate();
    return welder_.number_of(p);
  }

  double read_coordinate() {
    text_.skip_to_word();
    const Parsed<double> x = parse_double(text_.at(), text_.end());
    if (x.end == text_.at() || !text_.ends_word(x.end) || !std::isfinite(x.value))
      refuse("has the coordinate '", shown(text_.peek_word()), "', which is not a finite number");
    text_.move_to(x.end);
    return x.value;
  }

  /// The normal is not used. Of a facet without an area some programs write nan.
  void skip_normal() {
    text_.skip_to_word();
    const std::string_view word = text_.peek_word();
    if (word.empty() ||
        std::string_view("0123456789+-.nNiI").find(word[0]) == std::string_view::npos)
      refuse("has '", shown(word), "' where a number of its normal should be");
    text_.move_to(text_.at() + word.size());
  }

  bool next_is(std::string_view keyword) const { return is_keyword(text_.peek_word(), keyword); }

  void expect(std::string_view keyword) {
    text_.skip_to_word();
    if (text_.at_end()) text_.refuse("the text ends where '", keyword, "' should be");
    if (!next_is(keyword))
      refuse("'", shown(text_.peek_word()), "' where '", keyword, "' should be");
    text_.move_to(text_.at() + keyword.size());
  }

  template <class... Parts>
  [[noreturn]] void refuse(const Parts&... message) const {
    text_.refuse("facet #", mesh_.face_count() + 1, ' ', message...);
  }

  TextScanner text_;
  std::string_view name_;
  VertexWelder welder_;
  PolygonMesh mesh_;
};

}  // namespace tumble::detail
