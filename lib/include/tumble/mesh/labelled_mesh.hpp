#pragma once
/// @file
/// A mesh together with what its file calls the faces: bodies made of several materials.

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble::parts {

/// @addtogroup mesh
/// @{

/// What an OBJ file calls a face; empty where it says nothing. Names are the rest of their line,
/// without the blanks around them.
struct Label {
  std::string object;    ///< `o`
  std::string group;     ///< `g`: a name, or several with blanks between them
  std::string material;  ///< `usemtl`

  bool operator==(const Label&) const = default;
};

/// Faces that follow each other and have the same label.
struct LabelledFaces {
  int first;  ///< a face, from 0
  int end;    ///< the face behind the last one
  int label;  ///< index into LabelledMesh::labels

  bool operator==(const LabelledFaces&) const = default;
};

/// A mesh whose faces have labels.
struct LabelledMesh : PolygonMesh {
  std::vector<Label> labels;          ///< each once, and only those that a face has
  std::vector<LabelledFaces> ranges;  ///< in the order of the faces, all of which are in one

  LabelledMesh() = default;
  /// A mesh whose file names nothing.
  explicit LabelledMesh(PolygonMesh mesh) : PolygonMesh(std::move(mesh)) {
    if (face_count() == 0) return;
    labels.emplace_back();
    ranges.push_back({0, face_count(), 0});
  }
};

/// @}

}  // namespace tumble::parts

namespace tumble::detail {

/// Collects labels while the faces of a file are read. Faces cost nothing, only changes of the
/// label do.
class LabelReader {
 public:
  /// A name that holds from a face on.
  /// @param what one of the three names
  /// @param face the next one that is read
  void set(std::string parts::Label::*what, std::string name, int face) {
    end_range(face);
    current_.*what = std::move(name);
  }

  /// Puts labels and ranges beside the faces that were read.
  parts::LabelledMesh put_on(PolygonMesh mesh) {
    end_range(mesh.face_count());
    parts::LabelledMesh result;
    static_cast<PolygonMesh&>(result) = std::move(mesh);
    result.labels = std::move(labels_);
    result.ranges = std::move(ranges_);
    return result;
  }

 private:
  void end_range(int end) {
    const int first = ranges_.empty() ? 0 : ranges_.back().end;
    if (first == end) return;
    const int label = number_of_current();
    if (!ranges_.empty() && ranges_.back().label == label)
      ranges_.back().end = end;
    else
      ranges_.push_back({first, end, label});
  }

  int number_of_current() {
    // A name has no line breaks in it.
    const std::string key = current_.object + '\n' + current_.group + '\n' + current_.material;
    const auto [place, is_new] = numbers_.try_emplace(key, static_cast<int>(labels_.size()));
    if (is_new) labels_.push_back(current_);
    return place->second;
  }

  parts::Label current_;
  std::vector<parts::Label> labels_;
  std::vector<parts::LabelledFaces> ranges_;
  std::unordered_map<std::string, int> numbers_;  ///< of labels_
};

}  // namespace tumble::detail
