#pragma once
/// @file
/// A row of pictures of a body, each in its orientation and with its caption.

#include <string>
#include <vector>

#include "support/svg.hpp"
#include "support/view.hpp"

namespace tumble::support {

struct Picture {
  Mat3 R;               ///< body → viewer, any matrix: a drifted one shears the picture
  std::string caption;  ///< one line below
};

/// The mesh once for every picture, from left to right, all at the same scale, each with the middle
/// of its box in the middle of its cell.
/// @param size what a picture has room for, in the mesh's unit [m]
inline std::string gallery(const std::string& title, const PolygonMesh& mesh, double size,
                           const std::vector<Picture>& pictures) {
  constexpr double width = 760, caption_room = 44;
  const double cell = width / static_cast<double>(pictures.size());
  const double height = cell + caption_room;
  std::string svg = svg_open(width, height, title);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const double x = cell * (static_cast<double>(i) + 0.5);
    const double scale = cell / size;
    const Vec3 middle = pictures[i].R * bounds(mesh).center();
    svg += draw_mesh(mesh, pictures[i].R,
                     {x - scale * middle.x(), cell / 2 + 8 + scale * middle.y(), scale});
    svg += "<text x=\"" + svg_number(x) + "\" y=\"" + svg_number(height - 14) + "\" " +
           fill_of("ink") + " font-size=\"16\" text-anchor=\"middle\">" +
           svg_text(pictures[i].caption) + "</text>\n";
  }
  return svg + "</svg>\n";
}

}  // namespace tumble::support
