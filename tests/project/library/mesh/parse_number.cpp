#include "tumble/mesh/parse_number.hpp"

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdio>
#include <limits>

#include "project/harness/inputs.hpp"

using namespace tumble;

namespace {

/// Both ways to the same number; they must agree to the bit.
double parsed(const std::string& text) {
  const auto [value, end] = detail::parse_double(text.data(), text.data() + text.size());
  CAPTURE(text.substr(0, 60));
  CHECK(end == text.data() + text.size());
  const double other = detail::parse_by_strtod(text[0] == '+' ? text.substr(1) : text);
  CHECK(std::bit_cast<std::uint64_t>(value) == std::bit_cast<std::uint64_t>(other));
  return value;
}

/// How many letters belong to the number.
std::ptrdiff_t length_of_number(const std::string& text) {
  return detail::parse_double(text.data(), text.data() + text.size()).end - text.data();
}

std::string printed(const char* format, int digits, double x) {
  char text[2000];
  std::snprintf(text, sizeof text, format, digits, x);
  return text;
}

}  // namespace

TEST_CASE("parse_double: numbers as people write them") {
  CHECK(parsed("0") == 0);
  CHECK(parsed("+1.5") == 1.5);
  CHECK(parsed("-.25") == -0.25);
  CHECK(parsed("2.e-1") == 0.2);
  CHECK(parsed("1E5") == 1e5);
  CHECK(parsed("00000000000000000000000012.50") == 12.5);
  CHECK(std::signbit(parsed("-0")));
  CHECK(std::signbit(parsed("-0e999")));
}

TEST_CASE("parse_double: stops where the number ends") {
  for (const std::string none :
       {"", "-", "+", ".", "-.", "e5", "nan", "inf", "-inf", "+-1", "--1", " 1"})
    CHECK_MESSAGE(length_of_number(none) == 0, none);
  CHECK(length_of_number("0x10") == 1);
  CHECK(length_of_number("1,5") == 1);
  CHECK(length_of_number("3e") == 1);
  CHECK(length_of_number("3e+") == 1);
  CHECK(length_of_number("3e+x") == 1);
  CHECK(length_of_number("1.2.3") == 3);
  CHECK(length_of_number("1e2.5") == 3);
  const std::string text = "12345";  // not read beyond its end
  CHECK(detail::parse_double(text.data(), text.data() + 2).value == 12);
}

TEST_CASE("parse_double: halfway between two doubles, the even one") {
  CHECK(parsed("9007199254740993") == 9007199254740992.0);
  CHECK(parsed("9007199254740995") == 9007199254740996.0);
  const std::string zeros(780, '0');
  CHECK(parsed("9007199254740993." + zeros + "1") == 9007199254740994.0);
  CHECK(parsed("9007199254740992.9" + std::string(780, '9')) == 9007199254740992.0);
  CHECK(parsed("1.00000000000000011102230246251565404236316680908203125") == 1.0);
  CHECK(parsed("1.00000000000000011102230246251565404236316680908203126") == 1 + 0x1p-52);
  CHECK(parsed("1.00000000000000033306690738754696212708950042724609375") == 1 + 0x1p-51);
}

TEST_CASE("parse_double: at the edges of the exact case") {
  CHECK(parsed("9007199254740992e22") == 9007199254740992e22);
  CHECK(parsed("9007199254740993e22") == 9007199254740993e22);
  CHECK(parsed("1e22") == 1e22);
  CHECK(parsed("1e23") == 1e23);
  CHECK(parsed("123456789e-22") == 123456789e-22);
  CHECK(parsed("123456789e-23") == 123456789e-23);
  CHECK(parsed("0.1234567890123456789") == 0.1234567890123456789);
  CHECK(parsed("18446744073709551617") == 18446744073709551617.0);  // 2⁶⁴ + 1
  CHECK(parsed("8.5") == 8.5);
}

TEST_CASE("parse_double: subnormal, too small, too large") {
  using limits = std::numeric_limits<double>;
  CHECK(parsed("2.2250738585072014e-308") == limits::min());
  CHECK(parsed("2.2250738585072011e-308") == std::nextafter(limits::min(), 0));
  CHECK(parsed("4.9406564584124654e-324") == limits::denorm_min());
  CHECK(parsed("2.4703282292062328e-324") == limits::denorm_min());
  CHECK(parsed("2.4703282292062327e-324") == 0);
  CHECK(parsed("1e-400") == 0);
  CHECK(std::signbit(parsed("-1e-99999999999999999999")));
  CHECK(parsed("1.7976931348623158e308") == limits::max());
  CHECK(std::isinf(parsed("1.7976931348623159e308")));
  CHECK(parsed("-1e99999999999999999999") == -limits::infinity());
  CHECK(parsed("0." + std::string(400, '0') + "1e401") == 1);
  CHECK(parsed("1" + std::string(400, '0') + "e-400") == 1);
}

TEST_CASE("parse_double: any number of digits, as the C library reads them") {
  test::Random rng(3);
  for (int i = 0; i < 20000; ++i) {
    const double x = rng.uniform() * std::pow(10, rng.uniform(-20, 20));
    const int digits = static_cast<int>(rng.uniform(0, 25));
    parsed(printed("%.*e", digits, x));
    parsed(printed("%.*f", digits, x));
    CHECK(parsed(printed("%.*e", 16, x)) == x);
  }
  for (int i = 0; i < 300; ++i) {
    const double x = rng.uniform() * std::pow(2, rng.uniform(-1070, 1020));
    parsed(printed("%.*e", static_cast<int>(rng.uniform(17, 800)), x));
  }
}

TEST_CASE("parse_integer: saturates, and stops where the number ends") {
  const auto value = [](const std::string& text) {
    return detail::parse_integer(text.data(), text.data() + text.size()).value;
  };
  CHECK(value("+12/3") == 12);
  CHECK(value("-0007") == -7);
  CHECK(value("000000000000000000000000000000012") == 12);
  CHECK(value("4294967299") == 4294967299);
  CHECK(value(std::string(100, '9')) > 100'000'000'000'000'000);
  CHECK(value("-" + std::string(100, '9')) < -100'000'000'000'000'000);
  const std::string none = "+-1";
  CHECK(detail::parse_integer(none.data(), none.data() + 3).end == none.data());
}
