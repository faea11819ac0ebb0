#pragma once
/// @file
/// Objects of daily life that are thrown in the chapters: closed meshes in metres.

#include <array>

#include "objects/gear.hpp"
#include "objects/mug.hpp"
#include "objects/t_handle.hpp"
#include "objects/tennis_racket.hpp"
#include "objects/wing_nut.hpp"

namespace tumble::objects {

/// One of the objects.
struct Object {
  const char* name;
  const char* description;
  double density;                       ///< of what it is made of [kg/m³]
  PolygonMesh (*mesh)(int resolution);  ///< 1 is the coarsest; triangles grow as its square
  int for_drawings;                     ///< the resolution with some hundred triangles
  int fine;                             ///< the resolution with about 20,000 triangles
};

inline constexpr double steel = 7850, aluminium = 2700, stoneware = 2400,
                        ash_wood = 680;  // [kg/m³]

inline constexpr std::array<Object, 5> all = {
    Object{"t_handle", "the T-handle that turns over in orbit", aluminium, t_handle, 1, 7},
    Object{"wing_nut", "a wing nut of size M8", steel, wing_nut, 1, 6},
    Object{"tennis_racket", "a wooden tennis racket", ash_wood, tennis_racket, 1, 4},
    Object{"mug", "a mug with a handle", stoneware, mug, 1, 4},
    Object{"gear", "a spur gear with 18 involute teeth", steel, gear, 1, 9},
};

}  // namespace tumble::objects
