#pragma once
/// @file
/// The positions, the faces and their names of a Wavefront OBJ text in memory.
///
/// Source: Alias Wavefront, Advanced Visualizer manual, appendix B1, Object files (.obj): `v x y
/// z`, and `f` with the indices v, v/vt, v//vn or v/vt/vn, from 1 or, negative, from the last so
/// far; `o`, `g` and `usemtl` name the faces that follow.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

#include "tumble/mesh/foreign_format.hpp"
#include "tumble/mesh/labelled_mesh.hpp"
#include "tumble/mesh/obj_elsewhere.hpp"
#include "tumble/mesh/obj_keywords.hpp"
#include "tumble/mesh/obj_text.hpp"
#include "tumble/mesh/parse_number.hpp"

namespace tumble::detail {
/// Reads line by line. Lines that mean neither vertices nor faces nor their names are passed over
/// if the format has them, and refused if not: `V 1 2 3` would be a vertex that is missing.
class ObjReader {
 public:
  /// @param text the file, or its beginning up to the end of a line
  ObjReader(std::string_view text, std::string_view name)
      : text_(text, name), name_(name), beginning_(about_foreign_format(text)) {
    read_lines();
  }

  /// Reads on: in what follows, up to the end of a line.
  void read(std::string_view text) {
    text_.take(text);
    read_lines();
  }

  /// @throws std::invalid_argument if there were no faces
  parts::LabelledMesh mesh() {
    require(mesh_.face_count() > 0, name_, ": no faces (", mesh_.vertices.size(), " vertices)");
    return labels_.put_on(std::move(mesh_));
  }

 private:
  void read_lines() {
    for (; !text_.at_end(); text_.next_line()) {
      text_.skip_to_next_word();
      if (text_.begins_with('v'))
        read_vertex();
      else if (text_.begins_with('f'))
        read_face();
      else if (!text_.at_last_word())
        read_keyword();
    }
  }

  /// Colours or a weight after the three coordinates are passed over; they are numbers too.
  void read_vertex() {
    text_.move_to(text_.at() + 1);
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      text_.skip_to_next_word();
      const Parsed<double> x = parse_double(text_.at(), text_.end());
      if (x.end == text_.at() || !text_.ends_number(x.end) || !std::isfinite(x.value))
        refuse_coordinate(k);
      p[k] = x.value;
      text_.move_to(x.end);
    }
    for (text_.skip_to_next_word(); !text_.at_last_word(); text_.skip_to_next_word()) {
      const Parsed<double> x = parse_double(text_.at(), text_.end());
      if (x.end == text_.at() || !text_.ends_number(x.end))
        text_.refuse("'", shown(text_.peek_word()), "' behind the coordinates of vertex #",
                     mesh_.vertices.size() + 1, " is not a number");
      text_.move_to(x.end);
    }
    mesh_.vertices.push_back(p);
  }

  [[noreturn]] void refuse_coordinate(int k) const {
    if (text_.at_last_word()) text_.refuse("a vertex has 3 coordinates, not ", k);
    text_.refuse("the coordinate '", shown(text_.peek_word()), "' of vertex #",
                 mesh_.vertices.size() + 1, " is not a finite number");
  }

  void read_face() {
    text_.move_to(text_.at() + 1);
    text_.skip_to_next_word();
    if (text_.at_line_end()) return;  // a word without anything after it means nothing
    const std::size_t first = mesh_.corners.size();
    for (; !text_.at_last_word(); text_.skip_to_next_word()) mesh_.corners.push_back(read_corner());
    const std::size_t count = mesh_.corners.size() - first;
    if (count < 3) refuse_face("has ", count, " corners, and needs 3");
    if (mesh_.corners.size() > std::numeric_limits<int>::max())
      refuse_face("is one too many: a mesh has at most 2147483647 corners");
    mesh_.first_corner.push_back(static_cast<int>(mesh_.corners.size()));
  }

  /// The vertex that a corner means: #1 is the first of the file, −1 the last one so far.
  int read_corner() {
    const Parsed<std::int64_t> index = parse_integer(text_.at(), text_.end());
    const char* const end = end_of_corner(index.end);
    if (index.end == text_.at() || !text_.ends_number(end))
      refuse_face("has the vertex '", shown(text_.peek_word()), "', which is not an index");
    const auto count = static_cast<std::int64_t>(mesh_.vertices.size());
    const std::int64_t v = index.value > 0 ? index.value - 1 : count + index.value;
    if (index.value == 0 || v < 0 || v >= count) refuse_index(index.value);
    text_.move_to(end);
    return static_cast<int>(v);
  }

  /// Passes over the indices of texture and normal, of which there are no more than two, and either
  /// may be missing.
  /// @return the end of the word, or what should not be in it
  const char* end_of_corner(const char* at) const {
    for (int k = 0; k < 2 && at != text_.end() && *at == '/'; ++k)
      at = parse_integer(at + 1, text_.end()).end;
    return at;
  }

  [[noreturn]] void refuse_index(std::int64_t index) const {
    if (std::abs(index) > std::numeric_limits<int>::max())
      refuse_face("has the vertex '", shown(text_.peek_word()),
                  "', which is not an index: it is too large");
    const std::size_t count = mesh_.vertices.size();
    if (count == 0) refuse_face("has vertex ", index, ", but there are 0 vertices so far");
    refuse_face("has vertex ", index, ", but there are ", count, " vertices so far: #1 to #", count,
                ", or -1 to -", count);
  }

  /// What is elsewhere may be a closed part of its own, so that nothing else would show that it is
  /// missing.
  void read_keyword() {
    const std::string_view keyword = text_.next_word();
    const auto what = keyword == "o"        ? &parts::Label::object
                      : keyword == "g"      ? &parts::Label::group
                      : keyword == "usemtl" ? &parts::Label::material
                                            : nullptr;
    if (what != nullptr)
      labels_.set(what, std::string(text_.next_name()), mesh_.face_count());
    else if (is_passed_over(keyword))
      text_.pass_over_line();
    else
      refuse_keyword(keyword);
  }

  /// Refuses a line that cannot be passed over; one of bytes 0 alone only fills up the file.
  void refuse_keyword(std::string_view keyword) {
    if (without_padding(keyword).empty() && without_padding(text_.next_name()).empty()) return;
    if (const char* const elsewhere = what_is_elsewhere(keyword))
      text_.refuse("'", keyword, "' ", elsewhere);
    const std::string_view like = obj_keyword_like(keyword);
    if (!like.empty())
      text_.refuse("'", shown(keyword), "' is not a keyword of OBJ: did you mean '", like, "'?");
    text_.refuse("'", shown(keyword), "' is not a keyword of OBJ",
                 beginning_.empty() ? ": put a # before a line that means nothing" : beginning_);
  }

  template <class... Parts>
  [[noreturn]] void refuse_face(const Parts&... message) const {
    text_.refuse("face #", mesh_.face_count() + 1, ' ', message...);
  }

  ObjText text_;
  std::string_view name_;
  std::string beginning_;
  PolygonMesh mesh_;
  LabelReader labels_;
};

/// Reads an OBJ text. Polygons stay polygons, of any size; vertices that no face uses, and equal
/// ones, stay. Coordinates [m] are the doubles nearest to what is written. Texture, normals and
/// colours are passed over. Faces get the names of the objects, groups and materials they are in.
/// @param text the bytes of the file
/// @param name what the text is called in messages
/// @throws std::invalid_argument naming the line, and the face or vertex, for: a vertex before the
///         faces that is not there, an index 0, a face of fewer than 3 corners, a coordinate that
///         is missing or not a finite number, a line that brings in surfaces from elsewhere or
///         curved ones, a keyword that OBJ does not have, a text without faces
inline parts::LabelledMesh parse_obj(std::string_view text, std::string_view name) {
  return detail::ObjReader(text, name).mesh();
}

}  // namespace tumble::detail
