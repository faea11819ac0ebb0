#pragma once
/// @file
/// Mass properties as other programs' files want them. All three give the tensor about the centre
/// of mass, in the axes of the link, with products that carry the minus sign, as ours do.

#include <array>
#include <cstdio>
#include <string>

#include "tumble/core/require.hpp"
#include "tumble/mass/mass_properties.hpp"

namespace tumble::scenes {

/// All digits of a number.
inline std::string digits(double x) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", x == 0 ? 0.0 : x);
  return text.data();
}

inline std::string digits(const Vec3& v) {
  return digits(v.x()) + " " + digits(v.y()) + " " + digits(v.z());
}

/// Source: the URDF XML specification, `link`: the origin is the centre of mass in the link's
/// frame, ixy = −∫ x y dm.
inline std::string urdf_block(const MassProperties& body) {
  const Mat3& I = body.inertia;
  return "<inertial>\n  <origin xyz=\"" + digits(body.centre) +
         "\" rpy=\"0 0 0\"/>\n  <mass value=\"" + digits(body.mass) + "\"/>\n  <inertia ixx=\"" +
         digits(I(0, 0)) + "\" ixy=\"" + digits(I(0, 1)) + "\" ixz=\"" + digits(I(0, 2)) +
         "\" iyy=\"" + digits(I(1, 1)) + "\" iyz=\"" + digits(I(1, 2)) + "\" izz=\"" +
         digits(I(2, 2)) + "\"/>\n</inertial>\n";
}

/// Source: SDFormat specification 1.9, `inertial`: the pose is that of the centre of mass in the
/// link's frame.
inline std::string sdf_block(const MassProperties& body) {
  const Mat3& I = body.inertia;
  const auto element = [](const std::string& name, double x) {
    return "    <" + name + ">" + digits(x) + "</" + name + ">\n";
  };
  return "<inertial>\n  <pose>" + digits(body.centre) + " 0 0 0</pose>\n  <mass>" +
         digits(body.mass) + "</mass>\n  <inertia>\n" + element("ixx", I(0, 0)) +
         element("ixy", I(0, 1)) + element("ixz", I(0, 2)) + element("iyy", I(1, 1)) +
         element("iyz", I(1, 2)) + element("izz", I(2, 2)) + "  </inertia>\n</inertial>\n";
}

/// Source: MuJoCo, XML reference, `body/inertial`: fullinertia is M(1,1) M(2,2) M(3,3) M(1,2)
/// M(1,3) M(2,3), in the body's frame.
inline std::string mjcf_block(const MassProperties& body) {
  const Mat3& I = body.inertia;
  return "<inertial pos=\"" + digits(body.centre) + "\" mass=\"" + digits(body.mass) +
         "\" fullinertia=\"" + digits(Vec3(I.diagonal())) + " " +
         digits(Vec3(I(0, 1), I(0, 2), I(1, 2))) + "\"/>\n";
}

inline std::string inertial_block(const std::string& format, const MassProperties& body) {
  if (format == "urdf") return urdf_block(body);
  return format == "sdf" ? sdf_block(body) : mjcf_block(body);
}

}  // namespace tumble::scenes
