#include "support/moving_figure.hpp"

#include <doctest/doctest.h>

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>

#include "project/harness/inputs.hpp"
#include "project/harness/refusal.hpp"
#include "support/moving_declaration.hpp"
#include "support/svg.hpp"

using namespace tumble::support;

namespace {

constexpr std::array<Control, 2> controls{
    {{"h", "step", "s", 0, 1, 0.25, 0.5}, {"method", "method", "", 0, 2, 1, 1, "a|b|c"}}};
const MovingFigure figure{"thing", controls, [](Settings now) { return fixed_text(now[0], 2); }};

}  // namespace

TEST_CASE("moving figure: starts as declared, and takes settings by name, at its steps") {
  CHECK(start_of(figure) == std::vector<double>{0.5, 1});
  CHECK(settings_of(figure, {"method=2", "h=0.3"}) == std::vector<double>{0.25, 2});
  CHECK(figure.draw(settings_of(figure, {"h=1"})) == "1.00");
  CHECK(allowed(controls[0], 7) == 1);
  CHECK(allowed(controls[0], -7) == 0);
}

TEST_CASE("moving figure: refuses settings that are none, and says which") {
  CHECK_REFUSED(settings_of(figure, {"k=1"}), "thing", "no control 'k'; there are: h method");
  CHECK_REFUSED(settings_of(figure, {"h=1.5"}), "h is 1.5", "between 0 and 1");
  CHECK_REFUSED(settings_of(figure, {"h=nan"}), "h is");
  CHECK_REFUSED(settings_of(figure, {"h=much"}), "'h=much'", "NUMBER");
  CHECK_REFUSED(settings_of(figure, {"h="}), "'h='");
  CHECK_REFUSED(settings_of(figure, {"h"}), "'h'");
  CHECK_REFUSED(settings_of(figure, {""}), "no control ''");
}

TEST_CASE("moving figure: what a page has to know of it is JSON") {
  const auto json = nlohmann::json::parse(declaration_of(figure));
  CHECK(json["name"] == "thing");
  CHECK(json["plays"] == -1);
  CHECK(json["pace"] == 1);
  CHECK(json["drags"] == false);
  REQUIRE(json["controls"].size() == 2);
  CHECK(json["controls"][0]["unit"] == "s");
  CHECK(json["controls"][0]["step"] == 0.25);
  CHECK(json["controls"][1]["choices"] == "a|b|c");
}

TEST_CASE("fixed_text: what the standard's to_chars writes, to the last digit") {
  tumble::test::Random rng(2101);
  const auto standard = [](double value, int digits) {
    std::array<char, 64> text{};
    return std::string(text.data(), std::to_chars(text.data(), text.data() + text.size(), value,
                                                  std::chars_format::fixed, digits)
                                        .ptr);
  };
  for (int i = 0; i < 100'000; ++i) {
    const int digits = i % 16;
    const double halves = std::round(rng.uniform(-1e5, 1e5)) / (1 << i % 9);  // many ties
    const double any = rng.uniform(-1, 1) * std::pow(10, rng.uniform(-9, 8));
    for (const double value : {halves, any, halves * 0.005})
      if (std::abs(value) * std::pow(10, digits) < 0x1p51)
        REQUIRE(fixed_text(value, digits) == standard(value, digits));
  }
  CHECK(fixed_text(-0.0, 1) == "-0.0");
  CHECK_REFUSED(fixed_text(1e16, 1), "cannot show");
  CHECK_REFUSED(fixed_text(NAN, 1), "cannot show");
}
