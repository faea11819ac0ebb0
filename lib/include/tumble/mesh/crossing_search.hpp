#pragma once
/// @file
/// How hard places are looked for where a surface passes through itself.

namespace tumble::crossings {

/// @addtogroup mesh
/// @{

/// How places are looked for where a surface passes through itself.
enum class Search {
  usual,  ///< by some thousand lines along each axis; in meshes of up to 30,000 faces also pair by
          ///< pair
  thorough,  ///< pair by pair, exactly, in every mesh, where triangles only touch too
};

/// @}

}  // namespace tumble::crossings
