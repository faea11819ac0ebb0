#pragma once
/// @file
/// The triangles of a mesh in blocks of a few hundred, as kernels that work on many at once want
/// them: whole packs, and corners that can be read in pieces of four doubles.
///
/// A mesh of triangles is read where it lies. Polygons are cut into fans first. Copied are only the
/// blocks with the last vertex of all, behind which nothing may be read, and the last block of all
/// if it is no whole number of packs.

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "tumble/mesh/polygon_mesh.hpp"
#include "tumble/simd/instruction_set.hpp"

namespace tumble::detail {

/// The bits that are set in any of bits(0) … bits(n − 1). There is no way out of its loop: so a
/// compiler makes packs of it, and looking for something costs little beside reading it.
template <class Bits>
struct BitsOfAny {
  int n;
  Bits bits;  // inlined always
  int& result;

  template <class P, simd::Fma>
  TUMBLE_INLINE void run() const {
    int any = 0;
    for (int i = 0; i < n; ++i) any |= bits(i);
    result = any;
  }
};

template <class Bits>
int bits_of_any(simd::InstructionSet instructions, int n, const Bits& bits) {
  int result;
  dispatch(instructions, BitsOfAny<Bits>{n, bits, result});
  return result;
}

/// Triangles for a kernel.
struct TriangleBlock {
  const double* coordinates;  ///< x, y, z of corner 0, 1, …; behind the last one more can be read
  const int* corners;         ///< three a triangle: where their coordinates are
  const int* vertices;        ///< three a triangle: which vertices of the mesh they are
  int size;                   ///< how many triangles, a multiple of 8
  int padding;                ///< the last ones only fill up: a corner three times
  const int* faces;           ///< which face each triangle belongs to, or null:
  int first_face;             ///< then one after the other from this one

  int face(int triangle) const { return faces ? faces[triangle] : first_face + triangle; }
};

/// Cuts the faces of a mesh into blocks.
class TriangleBlocks {
 public:
  static constexpr int capacity = 512;  ///< triangles: what belongs to them stays in the next cache
  static constexpr int widest_pack = 8;

  /// @param mesh indices in range
  explicit TriangleBlocks(const PolygonMesh& mesh,
                          simd::InstructionSet instructions = simd::best_instruction_set())
      : mesh_(mesh),
        instructions_(instructions),
        last_vertex_(static_cast<int>(mesh.vertices.size()) - 1) {}

  /// Calls `visit(block)` for the triangles of the faces first … end − 1.
  template <class Visit>
  void for_each(int first, int end, const Visit& visit) {
    if (only_triangles(first, end)) {
      const int* vertices = mesh_.corners.data() + mesh_.first_corner[index(first)];
      for (int i = 0; i < end - first; i += capacity)
        pass_on(vertices + 3 * i, nullptr, first + i, std::min(capacity, end - first - i), visit);
    } else {
      cut_into_fans(first, end, visit);
    }
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  bool only_triangles(int first, int end) const {
    const auto other_size = [at = mesh_.first_corner.data() + first](int i)
        __attribute__((always_inline)) {
      return (at[i + 1] - at[i]) ^ 3;
    };
    return detail::bits_of_any(instructions_, end - first, other_size) == 0;
  }

  bool has_last_vertex(const int* vertices, int n) const {
    const auto is_last = [ vertices, last = last_vertex_ ](int i) __attribute__((always_inline)) {
      return int{vertices[i] == last};
    };
    return detail::bits_of_any(instructions_, n, is_last) != 0;
  }

  template <class Visit>
  void cut_into_fans(int first, int end, const Visit& visit) {
    const auto pass_on_fans = [&] {
      if (!faces_.empty())
        pass_on(fans_.data(), faces_.data(), 0, static_cast<int>(faces_.size()), visit);
      fans_.clear();
      faces_.clear();
    };
    for (int f = first; f < end; ++f) {
      const std::span<const int> face = mesh_.face(f);
      for (std::size_t k = 2; k < face.size(); ++k) {
        fans_.insert(fans_.end(), {face[0], face[k - 1], face[k]});
        faces_.push_back(f);
        if (faces_.size() == capacity) pass_on_fans();
      }
    }
    pass_on_fans();
  }

  template <class Visit>
  void pass_on(const int* vertices, const int* faces, int first_face, int size,
               const Visit& visit) {
    TriangleBlock block{
        mesh_.vertices.front().data(), vertices, vertices, size, 0, faces, first_face};
    if (has_last_vertex(vertices, 3 * size) || size % widest_pack != 0) copy(block);
    visit(block);
  }

  /// Lets a block have all its corners, and whole packs of them, in memory of its own.
  void copy(TriangleBlock& block) {
    block.padding = (widest_pack - block.size % widest_pack) % widest_pack;
    const std::size_t used = 3 * index(block.size), all = used + 3 * index(block.padding);
    coordinates_.clear();
    for (std::size_t k = 0; k < used; ++k) {
      const Vec3& x = mesh_.vertex(block.vertices[k]);
      coordinates_.insert(coordinates_.end(), {x.x(), x.y(), x.z()});
    }
    coordinates_.push_back(0);
    vertices_.assign(block.vertices, block.vertices + used);
    vertices_.resize(all, vertices_.front());
    corners_.resize(used);
    std::iota(corners_.begin(), corners_.end(), 0);
    corners_.resize(all, 0);
    block.coordinates = coordinates_.data();
    block.corners = corners_.data();
    block.vertices = vertices_.data();
    block.size += block.padding;
  }

  const PolygonMesh& mesh_;
  simd::InstructionSet instructions_;
  int last_vertex_;
  std::vector<int> fans_, faces_;        // of polygons
  std::vector<int> corners_, vertices_;  // of a block that was copied
  std::vector<double> coordinates_;
};

/// Has the corners fetched that come one block after these: while the kernel computes, the memory
/// would have nothing to do.
/// @tparam P the Pack whose triangles begin at `corners`
template <class P>
TUMBLE_INLINE void fetch_ahead(const int* corners) {
  constexpr int line = 64, bytes = 3 * simd::lanes<P> * sizeof(int);
  constexpr int ahead = 3 * TriangleBlocks::capacity * sizeof(int);
  for (int i = 0; i < bytes; i += line)  // as a number: it may lie behind the last corner
    // NOLINTNEXTLINE(performance-no-int-to-ptr)
    __builtin_prefetch(reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(corners) +
                                                     static_cast<std::uintptr_t>(ahead + i)));
}

}  // namespace tumble::detail
