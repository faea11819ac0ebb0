/// @file
/// An impact that fits on paper.

#include "common.hpp"
#include "parts.hpp"

namespace contact_chapter {

Table by_hand_table() {
  // 3 kg, 2 m: I = m l²/12 = 1 kg m² across. Nothing turns it about its own length, x.
  const RigidBody<> rod(3, Vec3(0.5, 1, 1).asDiagonal());
  RigidBodyState<> falling;
  falling.P = Vec3(0, 0, -12);
  const Vec3 end(1, 0, 0);
  const Mat3 K = contact::contact_matrix(rod, derived(rod, falling), end);
  const Vec3 u(0, 0, -4);
  const contact::ImpactResult hit = contact::collide({K, u, Vec3::UnitZ(), 0.5, 0});
  const RigidBodyState<> state = contact::after_impulse(falling, hit.impulse, end);
  const Derived<> after = derived(rod, state);
  Table table({"what", "before", "after"});
  table.add({"K_zz [1/kg]", rounded(K(2, 2)), ""});
  table.add({"impulse j [N s]", "", rounded(hit.impulse.z())});
  table.add({"v_z of the centre [m/s]", rounded(-4), rounded(after.v.z())});
  table.add({"ω_y [rad/s]", "0", rounded(after.omega.y())});
  table.add({"u_z of the end [m/s]", rounded(u.z()), rounded(hit.u.z())});
  table.add({"energy of the fall [J]", rounded(24), rounded(state.P.dot(after.v) / 2)});
  table.add({"energy of the turning [J]", "0", rounded(state.L.dot(after.omega) / 2)});
  table.add(
      {"energy [J]", rounded(kinetic_energy(rod, falling)), rounded(kinetic_energy(rod, state))});
  return table;
}

}  // namespace contact_chapter
