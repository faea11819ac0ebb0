#pragma once
/// @file
/// The true mass properties of the scanned meshes (density 1), by rational arithmetic from
/// the coordinates as doubles, 40 digits, rounded to 20; faces as fans of triangles from
/// their first corner.

#include <array>

#include "tumble/mass/mass_properties.hpp"

namespace tumble::reference {

/// A mesh file and what it truly encloses.
struct MeshTruth {
  const char* file;
  double volume;                 ///< [m³]
  std::array<double, 3> centre;  ///< [m]
  std::array<double, 6>
      inertia;  ///< about the centre: xx, yy, zz, xy, yz, zx; the last three −∫ [kg m²]

  MassProperties mass_properties() const {
    const auto& [xx, yy, zz, xy, yz, zx] = inertia;
    MassProperties truth{volume, {centre[0], centre[1], centre[2]}, Mat3::Zero()};
    truth.inertia << xx, xy, zx, xy, yy, yz, zx, yz, zz;
    return truth;
  }
};

inline constexpr MeshTruth mesh_truths[] = {
    {"spot.obj",
     7.1825878809986468822e-1,
     {-1.2181140881323190680e-6, -1.0344099445051789343e-2, 1.8827705913637519130e-1},
     {2.0932382902040561192e-1, 1.4524430573026873517e-1, 1.1351533611844758561e-1,
      7.4175815466670563825e-8, 6.2303686433824651731e-2, -8.9815262880564769710e-7}},
    {"spot_low.obj",
     6.7972889100271305024e-1,
     {4.5854684759904195977e-4, 2.1636538823268466401e-2, 1.9154023554515940570e-1},
     {2.1463888817005836109e-1, 1.4378568996008394799e-1, 1.1560762954699155384e-1,
      -2.6852254232466557722e-4, 7.1677941893756060340e-2, 2.0212058010377018941e-4}},
    {"spot_control.obj",
     8.4479106218955537836e-1,
     {0, -5.2594576283027718957e-2, 1.8927326809391585406e-1},
     {2.7415958900250247313e-1, 1.8277576934459234618e-1, 1.6027043102416303624e-1, 0,
      7.5986672817882940165e-2, 0}},
    {"fish_low.obj",
     1.1146213648424348752e+0,
     {2.2372377236476871371e-4, 1.1224085118442496326e-2, -1.9908245717642629701e-2},
     {3.4952250070059699670e-1, 3.4239068069768135960e-1, 1.5110884640454857849e-1,
      4.7526811693585805055e-5, 9.4702851053915017587e-3, 5.9825898319840099298e-5}},
};

}  // namespace tumble::reference
