/// @file
/// Names for wrong answers that every exercise has: from the numbers, and from the source.
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "judge/protocol/convert.hpp"
#include "judge/spec/general_misconceptions.hpp"
#include "judge/verdict/names_from_source.hpp"

using namespace tumble::judge;

namespace {

Finding wrong(Value answer, Value demanded, List arguments = {}) {
  Finding finding;
  finding.answer = std::move(answer);
  finding.demanded = std::move(demanded);
  finding.question = Question{std::move(arguments), 0};
  finding.tolerance = 1e-12;
  return finding;
}

std::string name_of_numbers(const Finding& finding) {
  const std::vector<Misconception> names = general_misconceptions(finding, Inputs::general);
  return names.empty() ? "" : names.front().name;
}

std::string name_of_source(Finding finding, const std::string& source) {
  name_from_source(finding, source);
  return finding.misconceptions.empty() ? "" : finding.misconceptions.front().name;
}

double from_bits(std::uint64_t bits) {
  double x = 0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

const Value right = List{1., 2., 3.};

}  // namespace

TEST_CASE("names: what the numbers show") {
  CHECK(name_of_numbers(wrong(List{-1., -2., -3.}, right)) == "the opposite sign");
  CHECK(name_of_numbers(wrong(List{1., std::nan(""), 3.}, List{1., std::log(-1.), 3.})) != "");
  CHECK(name_of_numbers(wrong(List{1., INFINITY, 3.}, right)) == "infinite");
  CHECK(name_of_numbers(wrong(List{4., 5., 6.}, right, {1., List{4., 5., 6.}})) ==
        "the argument as it came");
  const Value matrix = List{List{1., 2.}, List{3., 4.}},
              transposed = List{List{1., 3.}, List{2., 4.}};
  CHECK(name_of_numbers(wrong(transposed, matrix)) == "rows for columns");
}

TEST_CASE("names: a number that is one of many, or right, or of the wrong shape gets none") {
  CHECK(name_of_numbers(wrong(List{-1., 2., 3.}, right)) == "");
  // A skew-symmetric matrix: its transpose is its negative.
  const Value skew = List{List{0., 1.}, List{-1., 0.}}, other = List{List{0., -1.}, List{1., 0.}};
  CHECK(name_of_numbers(wrong(skew, other)) == "");
  CHECK(general_misconceptions(wrong(List{-1., -2., -3.}, right), Inputs::special).empty());
  CHECK(name_of_numbers(wrong(-1., 1.)) == "");  // one number alone proves no sign
  CHECK(name_of_numbers(wrong(List{1., 2.}, right)) == "");
  CHECK(name_of_numbers(wrong(List{}, right)) == "");
  CHECK(name_of_numbers(wrong(List(30'000, Value(1.)), right)) == "");
  CHECK(name_of_numbers(wrong(List{List{1.}, List{2., 3.}}, List{List{1., 2.}, List{3., 4.}})) ==
        "");
}

TEST_CASE("names: the marks of memory that was never set, of gcc and of clang") {
  for (const std::uint64_t bits :
       {0xfefefefefefefefeull, 0xaaaaaaaaaaaaaaaaull, 0xffffffffffffffffull, 0x7fffffffffffffffull})
    CHECK(name_of_numbers(wrong(List{1., from_bits(bits), 3.}, right)) == "never set");
  CHECK(name_of_numbers(wrong(List{1., 0.5 * from_bits(0xfefefefefefefefe), 3.}, right)) ==
        "never set");
  const double nan = std::numeric_limits<double>::quiet_NaN();  // and 0/0, and its negative
  for (const double x : {nan, -nan})
    CHECK(name_of_numbers(wrong(List{1., x, 3.}, right)) == "not a number");
  // A float and a bool on their way to a double and an int.
  for (const std::uint32_t bits : {0xfefefefeu, 0xffffffffu, 0x7fffffffu}) {
    float x = 0;
    std::memcpy(&x, &bits, sizeof x);
    CHECK(name_of_numbers(wrong(List{1., static_cast<double>(x), 3.}, right)) == "never set");
  }
  for (const char byte : {'\xfe', '\xaa'}) {
    bool never_set = false;
    std::memcpy(&never_set, &byte, 1);
    CHECK(name_of_numbers(wrong(to_value(never_set), std::int64_t{1})) == "never set");
  }
  CHECK(std::get<std::int64_t>(to_value(true).data) == 1);
  CHECK(std::get<std::int64_t>(to_value(false).data) == 0);
  CHECK(name_of_numbers(wrong(List{1.5e38, 2.}, List{2e38, 2.}, {1e37})) == "");
  // Huge numbers that were asked with are no mark.
  CHECK(name_of_numbers(wrong(List{1e300, 2.}, List{2e300, 2.}, {1e300})) == "");
}

TEST_CASE("names: whole-number division, in code and nowhere else") {
  const Finding finding = wrong(List{0., 0., 0.}, right);
  CHECK(name_of_source(finding, "double a = 1/2 * x;") == "whole-number division");
  CHECK(name_of_source(finding, "double a = (1 / 12) * x;") == "whole-number division");
  CHECK(name_of_source(finding, "a = x * y; b = x + 1/6 * k;") == "whole-number division");
  CHECK(name_of_source(finding, "#if 0\n#else\na = 1/2;\n#endif\n") == "whole-number division");
  CHECK(name_of_source(finding, "#if 1\n#if 0\n#endif\na = 1/2;\n#endif\n") ==
        "whole-number division");
  CHECK(name_of_source(finding, "f(R\"(a)\", 1/2);") == "whole-number division");
  for (const char* harmless : {"double a = 1./2 * x;",
                               "a = 1/2. * x;",
                               "a = n/2;",
                               "a = 4/2;",
                               "// 1/2\n",
                               "/* 1/2 */",
                               "\"1/2\"",
                               "a = x1/2;",
                               "a = 0x1/2;",
                               "a = 1e3/7;",
                               "a = '1' / 2;",
                               "a = 1/0;",
                               "y + h * 1/6 * (k1 + k2)",  // all in double: the product comes first
                               "x / 2 / 3",
                               "h * 3 / 4",
                               "h *\n  3 / 4",
                               "n % 5 / 2",
                               "a = 1'001/7;",
                               "a = 7/1'000'000.;",
                               "#if 0\na = 1/2;\n#endif\n",
                               "# if 0 // old\n#ifdef A\n#endif\na = 1/2;\n#endif\n",
                               "#if 1\n#if 0\na = 1/2;\n#endif\n#endif\n",
                               "R\"(\" 1/2)\"",
                               "u8R\"x()\" 1/2)x\"",
                               "const int middle = 7 / 2;",
                               "for (std::size_t i = 7 / 2; i < n; ++i) x += a[i];",
                               "x = a[7 / 2];"})
    CHECK_MESSAGE(name_of_source(finding, harmless) == "", harmless);
}

TEST_CASE("names: a misconception stands unless two whole numbers are divided") {
  Finding finding = wrong(List{0., 0., 0.}, right);
  finding.misconceptions = {{"sum of the slopes", "The weights are missing.", ""}};
  CHECK(name_of_source(finding, "return y + h * 1/6 * (k1 + k2);") == "sum of the slopes");
  CHECK(name_of_source(finding, "return y + 1/6 * h * (k1 + k2);") == "whole-number division");
}

TEST_CASE("names: a float, where 7 digits are right and there is one") {
  const Finding finding = wrong(List{1.0000001, 2., 3.}, right);
  for (const char* one : {"float a = x;",
                          "a = 0.5f * x;",
                          "a = x*.5F;",
                          "a = 1e-3f;",
                          "a = 1'000.f;",
                          "a = sqrtf(x);",
                          "a = std::acosf(x);",
                          "a = fabsf(x);",
                          "a = atan2f(y, x);",
                          "Eigen::Vector4f a;",
                          "VectorXf a(n);",
                          "Eigen::Matrix4f a;",
                          "MatrixXf a;",
                          "Matrix23f a;",
                          "RowVector3f a;",
                          "Eigen::ArrayXXf a;",
                          "Eigen::Quaternionf a;",
                          "AngleAxisf a;",
                          "std::vector<Vector2f> a;",
                          "x = static_cast<float>(y);",
                          "std::float_t a;"})
    CHECK_MESSAGE(name_of_source(finding, one) == "float", one);
  for (const char* none :
       {"double half = 0.5; // no float", "Vector3d a;", "int a = 0x1f;", "double a = of(x);",
        "double Vectorf = 1;", "a = self.f(x);", "#if 0\nfloat a;\n#endif\n", "double half = 1;",
        "a = b1f;", "double a = 1e5;", "Eigen::VectorOf a;"})
    CHECK_MESSAGE(name_of_source(finding, none) == "", none);
  CHECK(name_of_source(wrong(List{1.1, 2., 3.}, right), "float a = x;") == "");
}

TEST_CASE(
    "names: an auto that keeps an expression, not a lambda, a reference or a loop's element") {
  CHECK(tumble::judge::keeps_an_expression("const auto torque = skew(arm) * force;"));
  CHECK(tumble::judge::keeps_an_expression("auto  x\n = a * b;"));
  for (const char* harmless :
       {"const auto f = [&](double x) { return x; };", "const auto& x = a;", "for (auto x : list)",
        "// auto x = a * b;", "auto [a, b] = pair;", "myauto x = a * b;", "auto f(int n) -> int"})
    CHECK_MESSAGE(!tumble::judge::keeps_an_expression(harmless), harmless);
}

TEST_CASE("names: a sum that starts from a whole number") {
  const Finding finding = wrong(List{4., 5., 6.}, right);
  CHECK(name_of_source(finding, "s = std::accumulate(x.begin(), x.end(), 0);") ==
        "whole-number sum");
  CHECK(name_of_source(finding, "s = std::accumulate(begin(x), end(x),\n  0, add);") ==
        "whole-number sum");
  for (const char* source :
       {"s = std::accumulate(x.begin(), x.end(), 0.0);", "s = std::accumulate(a, b, 0.);",
        "s = std::accumulate(a, b, zero);", "// std::accumulate(a, b, 0)\n", "accumulates(a, 0)"})
    CHECK(name_of_source(finding, source) == "");
}

TEST_CASE("names: an auto whose expression is gone, with its line") {
  const std::string source = "f() {\n  auto a = 1;\n  auto k = h * f(t, y);\n  return y + k;\n}\n";
  const std::vector<tumble::judge::KeptExpression> kept = kept_expressions(source);
  REQUIRE(kept.size() == 2);
  CHECK(kept[0].line == 2);
  CHECK(kept[1].line == 3);
  const auto named = expression_that_outlives(source, "s.cpp:4: stack-use-after-scope");
  REQUIRE(named.has_value());
  CHECK(named->sentence.starts_with("The auto in line 3 may hold an expression of Eigen"));
  CHECK_FALSE(expression_that_outlives(source, "s.cpp:4: stack-overflow").has_value());
  CHECK_FALSE(expression_that_outlives(source, "s.cpp:1: heap-use-after-free").has_value());
  CHECK_FALSE(expression_that_outlives(source, "").has_value());
}

TEST_CASE("names: input that is not there") {
  Finding finding = wrong(List{4., 5., 6.}, right);
  for (const char* one : {"double x; std::cin >> x;", "scanf(\"%lf\", &x);", "int c = getchar();"})
    CHECK_MESSAGE(name_of_source(finding, one) == "input that is not there", one);
  for (const char* none : {"// std::cin", "double cine = 1;", "std::cout << x;"})
    CHECK_MESSAGE(name_of_source(finding, none) == "", none);
  finding.misconceptions = {{"never set", "Never set.", ""}};
  CHECK(name_of_source(finding, "std::cin >> x;") == "input that is not there");
  finding.misconceptions = {{"sign kept", "The sign.", ""}};
  CHECK(name_of_source(finding, "std::cin >> x;") == "sign kept");
}
