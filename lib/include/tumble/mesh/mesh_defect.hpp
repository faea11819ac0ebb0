#pragma once
/// @file
/// What can be wrong with a mesh, and how it is said.
///
/// Fields are indices into the mesh, from 0. Numbers in the text, behind a number sign, count from
/// 1, as an OBJ file does: the first face is `mesh.face(0)`.

#include <array>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "tumble/mesh/polygon_mesh.hpp"

namespace tumble {

/// @addtogroup mesh
/// @{

/// What can be wrong with a mesh.
enum class MeshDefectKind {
  no_faces,                  ///< nothing there
  index_out_of_range,        ///< a corner names a vertex that does not exist
  not_finite,                ///< a coordinate is NaN or infinite
  degenerate_face,           ///< fewer than 3 corners, a corner twice, or an area of exactly 0
  nonplanar_face,            ///< a polygon whose corners are not in one plane
  open_edge,                 ///< an edge with a face on one side only
  inconsistent_orientation,  ///< two neighbours go round in opposite senses
  duplicate_face,            ///< the same face twice
  uneven_edge,    ///< three or more faces at an edge, unequally many in the two directions
  flat,           ///< a part that encloses no volume
  inverted,       ///< a part whose faces look inwards, and nothing around it
  nested_wrong,   ///< a part inside another that looks outwards: its inside counts twice
  self_crossing,  ///< the surface passes through itself
};

/// One thing that is wrong, where it is, and what it means.
struct MeshDefect {
  MeshDefectKind kind{};
  int face = -1;                       ///< a face it can be seen at; −1: none
  std::array<int, 2> edge = {-1, -1};  ///< the edge, or twice the vertex; −1: none
  std::string message = {};            ///< a sentence
  /// Of a crossing: which share of the volume counts wrongly, and twice its standard error. Of
  /// parts that overlap: which share of the mass, at most. Of a flat part in the inside of a body:
  /// 0. NaN: there is no volume to share, or the finding is another one.
  double share = std::numeric_limits<double>::quiet_NaN();
  double share_uncertainty = std::numeric_limits<double>::quiet_NaN();
  /// Of a crossing: whether rounding of the file's last decimal may have made it, and it counts so
  /// little that it is a note.
  bool may_be_rounding = false;
};

/// The name of a kind, as in the code.
const char* name_of(MeshDefectKind kind);

inline std::ostream& operator<<(std::ostream& out, MeshDefectKind kind) {
  return out << name_of(kind);
}

/// Whether an integral over the mesh is wrong with it. All are but a degenerate face, which has no
/// area to add (a method that divides by the length of its normal gives NaN all the same), and a
/// face that is not plane, which is what its fan of triangles is (other programs may cut it along
/// another diagonal).
inline bool spoils_integrals(MeshDefectKind kind) {
  return kind != MeshDefectKind::degenerate_face && kind != MeshDefectKind::nonplanar_face;
}

namespace detail {

/// The share of the volume that may count wrongly before a mesh is refused, if nothing else is
/// said.
inline constexpr double crossing_tolerance = 1e-6;

/// The share that passes with a note, if rounding of the file's last decimal may have made it.
inline constexpr double rounding_share = 5 * crossing_tolerance;

/// The same in a file with as many digits as floats have, or more. Such digits were not chosen; far
/// from the origin, rounding alone changes the volume this much.
inline constexpr double rounding_share_of_floats = 100 * crossing_tolerance;

}  // namespace detail

/// Whether an integral over the mesh is wrong because of what was found. A crossing is a note as
/// long as no larger share of the volume than `tolerance` counts wrongly, or as rounding may have
/// made it.
inline bool spoils_integrals(const MeshDefect& defect,
                             double tolerance = detail::crossing_tolerance) {
  return spoils_integrals(defect.kind) && !(defect.share <= tolerance) && !defect.may_be_rounding;
}

/// Whether there is nothing that could be integrated over.
inline bool prevents_integrals(MeshDefectKind kind) {
  return kind == MeshDefectKind::no_faces || kind == MeshDefectKind::index_out_of_range ||
         kind == MeshDefectKind::not_finite;
}

namespace detail {

/// "vertex #3 at (0, 1, 0.5)".
std::string describe_vertex(const PolygonMesh& mesh, int v);

/// Findings of one kind: the first few in words, the others counted.
class MeshDefectsOfOneKind {
 public:
  static constexpr int max_shown = 5;
  explicit MeshDefectsOfOneKind(MeshDefectKind kind) : kind_(kind) {}

  /// Adds one; `describe()` is called only when its sentence will be shown.
  template <class Describe>
  void add(int face, std::array<int, 2> edge, Describe&& describe) {
    if (count_++ < max_shown) shown_.push_back(MeshDefect{kind_, face, edge, describe()});
  }

  int count() const { return count_; }

  /// Moves them to the end of `findings`; the last one says how many more there are.
  void append_to(std::vector<MeshDefect>& findings) {
    if (count_ > max_shown)
      shown_.back().message += " (and " + std::to_string(count_ - max_shown) + " more)";
    findings.insert(findings.end(), shown_.begin(), shown_.end());
  }

 private:
  MeshDefectKind kind_;
  int count_ = 0;
  std::vector<MeshDefect> shown_;
};

}  // namespace detail

/// @}

}  // namespace tumble

#ifndef TUMBLE_COMPILED
#include "tumble/mesh/mesh_defect.inl"
#endif
