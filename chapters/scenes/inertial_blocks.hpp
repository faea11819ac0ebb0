#pragma once
/// @file
/// Mass properties as other programs' files want them. All three give the tensor about the centre
/// of mass, in the axes of the link, with products that carry the minus sign, as ours do.

#include <cmath>
#include <string>

#include "support/shortest.hpp"
#include "tumble/mass/mass_properties.hpp"
#include "tumble/mass/validity.hpp"

namespace tumble::scenes {

using support::shortest;

inline std::string shortest(const Vec3& v) {
  return shortest(v.x()) + " " + shortest(v.y()) + " " + shortest(v.z());
}

/// Why there is no block: other programs want numbers that some body has. Empty if there is one.
inline std::string block_defect(const MassProperties& body) {
  if (body.mass == 0 && !body.centre.allFinite())
    return "the mesh encloses no volume, so there is no mass and no centre of mass to write down";
  if (!std::isfinite(body.mass) || !body.centre.allFinite() || !body.inertia.allFinite())
    return "the mass, the centre of mass or the inertia is no finite number";
  if (body.mass < 0) return "the mass is negative: the faces are inside out";
  const std::string defect = detail::inertia_defect(body.inertia);
  return defect.empty() ? defect : "the inertia tensor " + defect;
}

/// A comment in such a file. Two hyphens would end it.
inline std::string comment(std::string text) {
  for (auto at = text.find("--"); at != std::string::npos; at = text.find("--", at))
    text.insert(at + 1, " ");
  return "<!-- " + text + " -->\n";
}

/// Source: the URDF XML specification, `link`: the origin is the centre of mass in the link's
/// frame, ixy = −∫ x y dm.
inline std::string urdf_block(const MassProperties& body) {
  const Mat3& I = body.inertia;
  return "<inertial>\n  <origin xyz=\"" + shortest(body.centre) +
         "\" rpy=\"0 0 0\"/>\n  <mass value=\"" + shortest(body.mass) + "\"/>\n  <inertia ixx=\"" +
         shortest(I(0, 0)) + "\" ixy=\"" + shortest(I(0, 1)) + "\" ixz=\"" + shortest(I(0, 2)) +
         "\" iyy=\"" + shortest(I(1, 1)) + "\" iyz=\"" + shortest(I(1, 2)) + "\" izz=\"" +
         shortest(I(2, 2)) + "\"/>\n</inertial>\n";
}

/// Source: SDFormat specification 1.9, `inertial`: the pose is that of the centre of mass in the
/// link's frame.
inline std::string sdf_block(const MassProperties& body) {
  const Mat3& I = body.inertia;
  const auto element = [](const std::string& name, double x) {
    return "    <" + name + ">" + shortest(x) + "</" + name + ">\n";
  };
  return "<inertial>\n  <pose>" + shortest(body.centre) + " 0 0 0</pose>\n  <mass>" +
         shortest(body.mass) + "</mass>\n  <inertia>\n" + element("ixx", I(0, 0)) +
         element("ixy", I(0, 1)) + element("ixz", I(0, 2)) + element("iyy", I(1, 1)) +
         element("iyz", I(1, 2)) + element("izz", I(2, 2)) + "  </inertia>\n</inertial>\n";
}

/// Source: MuJoCo, XML reference, `body/inertial`: fullinertia is M(1,1) M(2,2) M(3,3) M(1,2)
/// M(1,3) M(2,3), in the body's frame.
inline std::string mjcf_block(const MassProperties& body) {
  const Mat3& I = body.inertia;
  return "<inertial pos=\"" + shortest(body.centre) + "\" mass=\"" + shortest(body.mass) +
         "\" fullinertia=\"" + shortest(Vec3(I.diagonal())) + " " +
         shortest(Vec3(I(0, 1), I(0, 2), I(1, 2))) + "\"/>\n";
}

inline std::string inertial_block(const std::string& format, const MassProperties& body) {
  if (format == "urdf") return urdf_block(body);
  return format == "sdf" ? sdf_block(body) : mjcf_block(body);
}

}  // namespace tumble::scenes
