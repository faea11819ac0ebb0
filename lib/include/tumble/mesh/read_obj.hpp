#pragma once
/// @file
/// Reads the positions and the faces of a Wavefront OBJ file. Needs tinyobjloader (tumble::obj).
///
/// tinyobjloader takes the file apart, but guesses where it should ask: `v nan 0 0` and `v 1 2`
/// become numbers, `f 1 2x 3` and an index beyond int become other vertices; and its own reading
/// of decimals is off by 1 to 6 ulp for half of all numbers (measured, rc10). So each line is
/// looked at again while its callback runs: coordinates are correctly rounded, and what is no
/// number is refused.

#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <istream>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tumble/core/require.hpp"
#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble {

/// Passes another stream on line by line, and remembers the line.
class LineBuffer : public std::streambuf {
 public:
  explicit LineBuffer(std::istream& source) : source_(source) {}
  const std::string& line() const { return line_; }
  std::int64_t number() const { return number_; }  ///< of the line, from 1

 protected:
  int_type underflow() override {
    if (!next_line()) return traits_type::eof();
    setg(text_.data(), text_.data(), text_.data() + text_.size());
    return traits_type::to_int_type(text_.front());
  }

 private:
  /// Lines end with \n, \r\n, or (on old machines) \r.
  bool next_line() {
    line_.clear();
    std::streambuf* in = source_.rdbuf();
    int c = in->sbumpc();
    if (c == traits_type::eof()) return false;
    for (; c != '\n' && c != '\r' && c != traits_type::eof(); c = in->sbumpc())
      line_ += static_cast<char>(c);
    if (c == '\r' && in->sgetc() == '\n') in->sbumpc();
    if (++number_ == 1 && line_.starts_with("\xEF\xBB\xBF")) line_.erase(0, 3);  // byte order mark
    text_ = line_ + '\n';
    return true;
  }

  std::istream& source_;
  std::string line_, text_;
  std::int64_t number_ = 0;
};

/// The words of a line, up to a comment.
inline std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t end = 0;;) {
    const std::size_t begin = line.find_first_not_of(" \t", end);
    if (begin == std::string_view::npos || line[begin] == '#') return result;
    end = std::min(line.find_first_of(" \t", begin), line.size());
    result.push_back(line.substr(begin, end - begin));
  }
}

/// The word without a leading plus sign, unless another sign follows.
inline std::string_view without_plus(std::string_view word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
  return plus ? word.substr(1) : word;
}

/// The double nearest to a decimal number, NaN for a word that is no finite number.
inline double parse_double(std::string_view word) {
  word = without_plus(word);
  double value = std::nan("");
#if defined(__cpp_lib_to_chars)
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = end == word.data() + word.size();
  // Too small for a double is 0; too large is no number.
  if (error == std::errc::result_out_of_range && whole)
    return std::strtod(std::string(word).c_str(), nullptr);
  return error == std::errc() && whole && std::isfinite(value) ? value : std::nan("");
#else
  std::istringstream stream{std::string(word)};
  stream.imbue(std::locale::classic());
  return stream >> value && stream.peek() == std::char_traits<char>::eof() ? value : std::nan("");
#endif
}

/// What the callbacks of tinyobjloader fill.
struct ObjReader {
  LineBuffer& lines;
  const std::string& name;
  PolygonMesh mesh;

  std::string place() const { return name + ", line " + std::to_string(lines.number()) + ": "; }

  void vertex() {
    const std::vector<std::string_view> word = words(lines.line());
    require(word.size() >= 4, place(), "a vertex has 3 coordinates, not ", word.size() - 1);
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      const std::string_view text = word[static_cast<std::size_t>(k) + 1];
      p[k] = parse_double(text);
      require(std::isfinite(p[k]), place(), "the coordinate '", text.substr(0, 40), "' of vertex #",
              mesh.vertices.size() + 1, " is not a finite number");
    }
    mesh.vertices.push_back(p);
  }

  void face(const tinyobj::index_t* indices, int count) {
    const std::vector<std::string_view> word = words(lines.line());
    const int number = mesh.face_count() + 1;
    const auto corner_count = static_cast<int>(word.size()) - 1;
    require(corner_count >= 3, place(), "face #", number, " has ", std::max(corner_count, 0),
            " corners, and needs 3");
    require(corner_count <= count, place(), "face #", number, " has a corner that is not an index");
    std::vector<int> corners;
    for (int k = 0; k < corner_count; ++k)
      corners.push_back(
          corner(word[static_cast<std::size_t>(k) + 1], indices[k].vertex_index, number));
    mesh.add_face(corners);
  }

  /// The vertex that a corner means: #1 is the first of the file, −1 the last one so far.
  int corner(std::string_view word, int index, int face_number) const {
    word = without_plus(word.substr(0, word.find('/')));
    int value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool is_number =
        error == std::errc() && end == word.data() + word.size() && value == index;
    const auto vertex_count = static_cast<int>(mesh.vertices.size());
    require(is_number, place(), "face #", face_number, " has the vertex '", word.substr(0, 40),
            "', which is not an index");
    require(index != 0 && index <= vertex_count && index >= -vertex_count, place(), "face #",
            face_number, " has vertex ", index, ", but there are ", vertex_count,
            " vertices so far: #1 to #", vertex_count, ", or -1 to -", vertex_count);
    return index > 0 ? index - 1 : vertex_count + index;
  }
};

/// Reads a mesh. Polygons stay polygons, of any size; vertices that no face uses, and
/// equal ones, stay.
/// @param name what the text is called in messages
/// @throws std::invalid_argument naming the line, and the face or vertex, for: a vertex before the
///         faces that is not there, an index 0, a face of fewer than 3 corners, a coordinate that
///         is missing or not a finite number, a text without faces
inline PolygonMesh read_obj(std::istream& in, const std::string& name) {
  LineBuffer lines(in);
  ObjReader reader{lines, name, {}};
  tinyobj::callback_t callback;
  callback.vertex_cb = [](void* user, double, double, double, double) {
    static_cast<ObjReader*>(user)->vertex();
  };
  callback.index_cb = [](void* user, tinyobj::index_t* indices, int count) {
    static_cast<ObjReader*>(user)->face(indices, count);
  };
  std::istream line_stream(&lines);
  std::string warning, error;
  const bool good =
      tinyobj::LoadObjWithCallback(line_stream, callback, &reader, nullptr, &warning, &error);
  require(good, name, ": ", error);
  require(reader.mesh.face_count() > 0, name, ": no faces (", reader.mesh.vertices.size(),
          " vertices)");
  return std::move(reader.mesh);
}

/// Reads a mesh from a file.
/// @throws std::runtime_error when the file cannot be read; else as above
inline PolygonMesh read_obj(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  file.peek();  // a directory can be opened, but not read
  if (!file.is_open() || file.bad()) throw std::runtime_error(path + ": cannot be read");
  file.clear();
  return read_obj(file, path);
}

}  // namespace tumble
