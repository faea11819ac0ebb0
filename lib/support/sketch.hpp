#pragma once
/// @file
/// Drawings in the plane: curves, arrows, discs and words at points of the world, one unit as long
/// to the right as up.

#include <string>
#include <vector>

#include "support/svg.hpp"
#include "support/svg_path.hpp"
#include "tumble/core/types.hpp"

namespace tumble::support {

using Vec2 = Eigen::Vector2d;

/// Where the world's origin is drawn, and how large the world.
struct Window {
  double x, y;   ///< [px] from the upper left corner
  double scale;  ///< [px/unit]
};

/// How a line looks.
struct Pen {
  std::string colour;  ///< of the style: "ink", "faint", "grid", "c0" … "c9"
  double width = 1.8;  ///< [px]
  double opacity = 1;  ///< how much it covers what is below
  double fill = 0;     ///< the same of what it encloses; 0 leaves the inside empty
};

class Sketch {
 public:
  /// @param title     for screen readers
  /// @param text_size [px]; a wide drawing is shrunk on a phone, and its words with it
  Sketch(double width, double height, const std::string& title, double text_size = 17)
      : svg_(svg_open(width, height, title)), text_size_(text_size) {}

  /// What is drawn from now on is drawn in this window.
  void look(const Window& window) { window_ = window; }

  /// One line through all points, in the order given.
  void curve(const std::vector<Vec2>& points, const Pen& pen) { curves({points}, pen); }

  /// Several lines of the same look.
  void curves(const std::vector<std::vector<Vec2>>& lines, const Pen& pen) {
    SvgPath path;
    for (const std::vector<Vec2>& line : lines) add(path, line);
    svg_ += "<path d=\"" + path.text() + "\" stroke-linejoin=\"round\" " + look_of(pen) + "/>\n";
  }

  /// The outline of a rectangle.
  void frame(const Vec2& low, const Vec2& high, const Pen& pen) {
    curve({low, {high.x(), low.y()}, high, {low.x(), high.y()}, low}, pen);
  }

  /// A line with a head at its end.
  void arrow(const Vec2& from, const Vec2& to, const Pen& pen) {
    const Vec2 along = (to - from).normalized() * 9 / window_.scale;
    const Vec2 across = Vec2(-along.y(), along.x()) * 0.42;
    curves({{from, to}, {to - along + across, to, to - along - across}}, pen);
  }

  /// @param radius [unit]
  void disc(const Vec2& centre, double radius, const std::string& colour) {
    circle(centre, radius * window_.scale, colour);
  }

  /// A disc of the same size at any scale.
  void dot(const Vec2& centre, const std::string& colour, double pixels = 4) {
    circle(centre, pixels, colour);
  }

  /// Many dots alike.
  void dots(const std::vector<Vec2>& centres, const std::string& colour, double pixels) {
    svg_ += "<g " + fill_of(colour) + ">\n";
    for (const Vec2& centre : centres) svg_ += circle_at(centre, pixels) + "/>\n";
    svg_ += "</g>\n";
  }

  /// Thousands of dots alike, as one path: each a line of no length with round ends.
  void specks(const std::vector<Vec2>& centres, const std::string& colour, double radius) {
    SvgPath path;
    for (const Vec2& centre : centres) {
      const Vec2 p = pixels(centre);
      path.speck(p.x(), p.y());
    }
    svg_ += "<path d=\"" + path.text() + "\" fill=\"none\" " + stroke_of(colour) +
            " stroke-width=\"" + svg_number(2 * radius) + "\" stroke-linecap=\"round\"/>\n";
  }

  /// Where a reader takes hold of a figure that moves: unseen, around one point or along a line.
  /// It lies above all that is drawn, or a press on the arrow itself would miss it.
  /// @param reach [px] to each side: a finger is wide
  void grip(const std::vector<Vec2>& line, double reach = 24) {
    SvgPath path;
    add(path, line);
    grips_ += "<path class=\"grip\" d=\"" + path.text() + (line.size() == 1 ? "h0" : "") +
              "\" fill=\"none\" stroke=\"transparent\" stroke-width=\"" + svg_number(2 * reach) +
              "\" stroke-linecap=\"round\"/>\n";
  }

  /// What has been drawn elsewhere, in pixels, such as a mesh.
  void drawing(const std::string& svg) { svg_ += svg; }

  /// Words beside a point, with a rim of paper that parts them from the lines below.
  /// @param offset [px] right and down of the point
  /// @param anchor "start", "middle" or "end": which part of the words is there
  void words(const Vec2& point, const Vec2& offset, const std::string& text,
             const std::string& colour = "ink", const std::string& anchor = "start") {
    const Vec2 p = pixels(point) + offset;
    svg_ += "<text x=\"" + svg_number(p.x()) + "\" y=\"" + svg_number(p.y()) + "\" " +
            fill_of(colour) + " " + stroke_of("paper") +
            " stroke-width=\"4\" paint-order=\"stroke\" font-size=\"" + svg_number(text_size_) +
            "\" text-anchor=\"" + anchor + "\">" + svg_words(text) + "</text>\n";
  }

  /// The name of an arrow, beyond its tip and clear of it.
  void name_at_tip(const Vec2& from, const Vec2& to, const std::string& name,
                   const std::string& colour = "ink") {
    constexpr double gap = 8;
    const Vec2 along = (to - from).normalized();
    const Vec2 half(text_width(name, text_size_) / 2, 0.38 * text_size_);
    const double away = gap + along.cwiseAbs().dot(half);
    words(to, {away * along.x(), half.y() - away * along.y()}, name, colour, "middle");
  }

  /// The drawing as a complete SVG document.
  std::string svg() const { return svg_ + grips_ + "</svg>\n"; }

 private:
  Vec2 pixels(const Vec2& point) const {
    return {window_.x + window_.scale * point.x(), window_.y - window_.scale * point.y()};
  }

  void add(SvgPath& path, const std::vector<Vec2>& line) const {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Vec2 p = pixels(line[i]);
      path.add(p.x(), p.y(), i == 0);
    }
  }

  void circle(const Vec2& centre, double radius, const std::string& colour) {
    svg_ += circle_at(centre, radius) + " " + fill_of(colour) + "/>\n";
  }

  std::string circle_at(const Vec2& centre, double radius) const {
    const Vec2 p = pixels(centre);
    return "<circle cx=\"" + svg_number(p.x()) + "\" cy=\"" + svg_number(p.y()) + "\" r=\"" +
           svg_number(radius) + "\"";
  }

  static std::string look_of(const Pen& pen) {
    const std::string inside =
        pen.fill > 0 ? fill_of(pen.colour) + " fill-opacity=\"" + svg_number(pen.fill, 2) + "\""
                     : "fill=\"none\"";
    return inside + " " + stroke_of(pen.colour) + " stroke-width=\"" + svg_number(pen.width) +
           "\"" + (pen.opacity < 1 ? " opacity=\"" + svg_number(pen.opacity, 2) + "\"" : "");
  }

  std::string svg_, grips_;
  double text_size_;
  Window window_{0, 0, 1};
};

}  // namespace tumble::support
