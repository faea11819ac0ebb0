#include "support/plot.hpp"

#include <doctest/doctest.h>

#include <cmath>

#include "project/harness/refusal.hpp"
#include "support/plot_layout.hpp"
#include "support/table.hpp"
#include "support/view.hpp"

using namespace tumble;
using namespace tumble::support;

namespace {

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("svg_number: short, and the same everywhere") {
  CHECK(svg_number(1.25, 1) == "1.2");
  CHECK(svg_number(100) == "100");
  CHECK(svg_number(-0.01) == "0");
  CHECK(svg_number(0.5, 3) == "0.5");
}

TEST_CASE("axis: ticks of numbers as small and as large as doubles are") {
  const auto labels = [](double low, double high) {
    FittedAxis axis({"speed [m/s]"});
    axis.include(low);
    axis.include(high);
    axis.finish();
    std::vector<std::string> all;
    for (const Tick& tick : axis.ticks()) all.push_back(tick.label);
    return all;
  };
  CHECK(labels(0, 1) == std::vector<std::string>{"0", "0.2", "0.4", "0.6", "0.8", "1"});
  CHECK(labels(0, 1e-299).back() == "1 · 10⁻²⁹⁹");
  CHECK(labels(0, 5e59) ==
        std::vector<std::string>{"0", "1 · 10⁵⁹", "2 · 10⁵⁹", "3 · 10⁵⁹", "4 · 10⁵⁹", "5 · 10⁵⁹"});
  CHECK(labels(-1e20, 1e20).front() == "-1 · 10²⁰");
  CHECK(labels(1e20, 1e20 + 1e16)[1] == "1.00002 · 10²⁰");
}

TEST_CASE("svg_text: what XML reserves is escaped") {
  CHECK(svg_text("a<b & c>d") == "a&lt;b &amp; c&gt;d");
}

TEST_CASE("svg_words: a number below zero has a minus sign, a word keeps its hyphen") {
  CHECK(svg_words("-0.5") == "−0.5");
  CHECK(svg_words("energy -39.3 %") == "energy −39.3 %");
  CHECK(svg_words("(-1, 2)") == "(−1, 2)");
  CHECK(svg_words("-") == "-");
  CHECK(svg_words("T-handle <1e-9") == "T-handle &lt;1e-9");
}

TEST_CASE("svg_words: a symbol's subscript stands lower, a name of the code stays as it is") {
  const auto low = [](const std::string& words) {
    return "<tspan dy=\"3\" font-size=\"75%\">" + words + "</tspan>";
  };
  const std::string up = "<tspan dy=\"-3\">", end = "</tspan>";
  CHECK(svg_words("RK4, ω_body") == "RK4, ω" + low("body"));
  CHECK(svg_words("x_0") == "x" + low("0"));
  CHECK(svg_words("p_body × n_γ dA") ==
        "p" + low("body") + up + " × n" + low("γ") + up + " dA" + end + end);
  for (const char* words : {"tumble, simulate_contacts", "centre_rest", "_x", "x_", "x_ y", "ωx_y"})
    CHECK(svg_words(words) == words);
}

TEST_CASE("axis: ticks are round numbers that span the data") {
  FittedAxis linear({"t"});
  linear.include(0.13);
  linear.include(9.7);
  linear.finish();
  const std::vector<Tick> ticks = linear.ticks();
  REQUIRE(ticks.size() == 6);
  CHECK(ticks.front().label == "0");
  CHECK(ticks.back().label == "10");
  CHECK(linear.position(5) == doctest::Approx(0.5));

  FittedAxis log({"error", Scale::log});
  log.include(2e-5);
  log.include(3e-2);
  log.include(0);  // cannot be shown
  log.finish();
  CHECK(log.ticks().front().label == "10⁻⁵");
  CHECK(log.ticks().back().label == "10⁻¹");
  CHECK(log.position(1e-3) == doctest::Approx(0.5));
}

TEST_CASE("axis: one value, or none, still makes an axis") {
  for (const Scale scale : {Scale::linear, Scale::log}) {
    FittedAxis one({"x", scale}), none({"x", scale});
    one.include(1);
    one.finish();
    none.finish();
    for (const FittedAxis& axis : {one, none}) {
      CHECK(axis.ticks().size() >= 2);
      CHECK(axis.position(1) >= 0);
      CHECK(axis.position(1) <= 1);
    }
  }
}

TEST_CASE("plot: draws each curve once, with its name; breaks it where a point cannot be shown") {
  Plot plot{"title",
            {"x"},
            {"y", Scale::log},
            {{"good & bad", {1, 2, 3, 4}, {1, 0, 10, 100}}, {"b", {1}, {1}}}};
  const std::string svg = to_svg(plot);
  CHECK(count(svg, "<path") == 4);  // two lines, and the markers on each
  CHECK(count(svg, "class=\"marks\"") == 2);
  CHECK(count(svg, "good &amp; bad") == 1);
  const std::string path = svg.substr(svg.find("<path d=\"") + 9);
  CHECK(count(path.substr(0, path.find('"')), "M") == 2);
  CHECK(svg.rfind("</svg>\n") == svg.size() - 7);
}

TEST_CASE("plot: names at the ends do not overlap and stay in the figure") {
  Plot plot{"title", {"x"}, {"y"}, {}};
  for (int i = 0; i < 12; ++i)
    plot.series.push_back({"curve " + std::to_string(i), {0, 1}, {i / 100.0, 0}});
  const std::vector<plot_detail::Label> labels = plot_detail::layout(plot).labels;
  REQUIRE(labels.size() == 12);
  for (const plot_detail::Label& a : labels) {
    CHECK(a.box.x > 0);
    CHECK(a.box.x + a.box.width < plot_detail::width);
    CHECK(a.box.y > 0);
    for (const plot_detail::Label& b : labels)
      CHECK_FALSE((a.series != b.series && a.box.meets(b.box)));
  }
}

TEST_CASE(
    "plot: a name stands beside its curve's end where there is room, else at a leader's end") {
  Plot plot{"", {"x"}, {"y"}, {{"early", {0, 1}, {0, 1}}, {"late", {0, 4}, {0, 0}}}};
  for (const plot_detail::Label& label : plot_detail::layout(plot).labels)
    CHECK_FALSE(label.has_leader());
  CHECK(count(to_svg(plot), "stroke-width=\"0.8\"") == 0);

  for (int i = 0; i < 8; ++i) plot.series.push_back({"crowd " + std::to_string(i), {0, 4}, {0, 0}});
  CHECK(count(to_svg(plot), "stroke-width=\"0.8\"") > 0);
}

TEST_CASE("plot: names that stand one above the other are in the order of their curves' ends") {
  Series falling{"one case: by w", {}, {}}, level{"four cases", {}, {}};
  for (double x = 1e-8; x < 2; x *= 10) {
    falling.x.push_back(x), falling.y.push_back(6e-16 / (x * x));
    level.x.push_back(x), level.y.push_back(3e-16);
  }
  const Plot plot{"", {"x", Scale::log}, {"y", Scale::log}, {falling, level}};
  const auto labels = plot_detail::layout(plot).labels;
  REQUIRE(labels.size() == 2);
  CHECK(labels[0].anchor.y < labels[1].anchor.y);
  CHECK(labels[0].box.y < labels[1].box.y);
}

TEST_CASE("plot: a name covers neither markers, nor a curve beside its own, nor the axis") {
  // What falls to the axis in a cloud of dots, beside one that falls nearly alike.
  Series falling{"DP 5(4), adaptive", {}, {}}, beside{"DOP853", {}, {}}, cloud{"bodies", {}, {}};
  cloud.look = Look::dots;
  for (int i = 0; i <= 20; ++i) {
    falling.x.push_back(1 + 0.1 * i), falling.y.push_back(std::pow(10, -0.5 * i));
    beside.x.push_back(1.1 + 0.1 * i), beside.y.push_back(std::pow(10, -0.5 * i));
    cloud.x.push_back(3.4 + 0.05 * i), cloud.y.push_back(std::pow(10, -9 - 0.05 * (i % 5)));
  }
  const Plot plot{"", {"x"}, {"y", Scale::log}, {falling, beside, cloud}};
  const plot_detail::Layout placed = plot_detail::layout(plot);
  for (const plot_detail::Label& label : placed.labels) {
    CAPTURE(plot.series[label.series].name);
    for (const Series& series : plot.series)
      for (const plot_detail::Pixel& p : plot_detail::dense(series, placed.frame))
        CHECK_FALSE(label.box.holds(p, 5));
    const double below = label.box.y + label.box.height - placed.frame.floor();
    CHECK_FALSE((label.box.x < placed.frame.right_end() && std::abs(below) < 2));
  }
}

TEST_CASE("plot: a single dot has its name beside it") {
  const Plot plot{"", {"x"}, {"y"}, {{"a", {0}, {0}}, {"b", {4}, {4}}, {"c", {9}, {1}}}};
  for (const plot_detail::Label& label : plot_detail::layout(plot).labels)
    CHECK(plot_detail::distance(label.anchor, label.box.nearest(label.anchor)) < 10);
}

TEST_CASE("plot: a curve with a coordinate missing is refused") {
  CHECK_REFUSED(to_svg(Plot{"drift", {"x"}, {"y"}, {{"RK4", {1, 2}, {1}}}}), "drift", "RK4", "2 x",
                "1 y");
}

TEST_CASE("plot: a long curve has a few markers, at other places than its neighbour") {
  Plot plot{"", {"x"}, {"y"}, {{"a", {}, {}}, {"b", {}, {}}}};
  for (Series& series : plot.series)
    for (int i = 0; i <= 1000; ++i) series.x.push_back(i), series.y.push_back(i);
  const plot_detail::Frame frame = plot_detail::fitted_frame(plot);
  const auto curve = plot_detail::pieces(plot.series[0], frame);
  const auto a = plot_detail::places_along(curve, 0.25), b = plot_detail::places_along(curve, 0.75);
  CHECK(a.size() >= 3);
  CHECK(a.size() <= 7);
  for (const plot_detail::Pixel& p : a)
    for (const plot_detail::Pixel& q : b) CHECK(plot_detail::distance(p, q) > 20);
}

TEST_CASE("table: columns line up, also with letters of several bytes; CSV quotes what it must") {
  Table table({"method", "error"});
  table.add({"Gram–Schmidt", "1"});
  table.add({"a,b \"c\"", "22"});
  CHECK(table.text() ==
        "  method         error\n"
        "  ────────────   ─────\n"
        "  Gram–Schmidt       1\n"
        "  a,b \"c\"           22\n");
  CHECK(table.csv() == "method,error\nGram–Schmidt,1\n\"a,b \"\"c\"\"\",22\n");
  CHECK_REFUSED(table.add({"one"}), "1 cells", "2 columns");
}

TEST_CASE("duration: in the unit that fits") {
  CHECK(duration(1.5e-8) == "15 ns");
  CHECK(duration(2.5e-5) == "25 µs");
  CHECK(duration(0.0125) == "12.5 ms");
  CHECK(duration(3) == "3 s");
}

TEST_CASE("draw_mesh: shows the faces turned to the viewer, the near ones last") {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  mesh.add_face({3, 4, 5});  // near, towards the viewer
  mesh.add_face({0, 1, 2});  // far, towards the viewer
  mesh.add_face({0, 2, 1});  // turned away
  const std::string svg = draw_mesh(mesh, Mat3::Identity(), {0, 0, 10});
  CHECK(count(svg, "M0 0l10 0 -10 -10Z") == 2);
  const Mat3 flipped = Vec3(1, -1, -1).asDiagonal();
  CHECK(count(draw_mesh(mesh, flipped, {0, 0, 10}), "Z") == 1);
}

TEST_CASE("coarsened: merges what is near and drops the faces that vanish") {
  PolygonMesh mesh;
  mesh.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0.1, 0, 0}};
  mesh.add_face({0, 1, 2});
  mesh.add_face({0, 3, 2});
  const PolygonMesh coarse = coarsened(mesh, 10);
  CHECK(coarse.vertices.size() == 3);
  CHECK(coarse.face_count() == 1);
}

TEST_CASE("plot: with equal scales a unit is as long on both axes") {
  Plot plot{"a path", {"x"}, {"y"}, {{"a", {0, 4}, {0, 1}}}, Aspect::equal};
  const plot_detail::Frame frame = plot_detail::fitted_frame(plot);
  CHECK(frame.px(3) - frame.px(2) == doctest::Approx(frame.py(0) - frame.py(1)));
}

TEST_CASE("plot: dots alone have no line") {
  const Plot plot{"dots", {"x"}, {"y"}, {{"a", {0, 1}, {0, 1}, Look::dots}}};
  CHECK(count(to_svg(plot), "<path") == 1);
  CHECK(count(to_svg(plot), "stroke-width=\"1.8\"") == 0);
}

TEST_CASE("plot: a dashed line is one, with its markers") {
  const Plot plot{"", {"x"}, {"y"}, {{"there", {1, 2}, {1, 2}, Look::dashed}}};
  const std::string svg = to_svg(plot);
  CHECK(count(svg, "stroke-dasharray") == 1);
  CHECK(count(svg, "class=\"marks\"") == 1);
}

TEST_CASE("plots below each other are one document, and so are the notes below them") {
  const Plot plot{"one", {"x"}, {"y"}, {{"curve", {1, 2}, {1, 2}}}};
  const std::string svg = to_svg("all", {plot, plot}, {"a < b", "more"});
  CHECK(count(svg, "<svg") == 1);
  CHECK(count(svg, "<style>") == 1);
  CHECK(count(svg, ">curve</text>") == 2);
  CHECK(count(svg, ">a &lt; b</text>") == 1);
  CHECK(count(svg, "height=\"930\"") == 1);  // 2 (44 + 340 + 56) + 2 · 19 + 12
}
