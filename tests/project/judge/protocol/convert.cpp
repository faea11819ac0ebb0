/// @file
/// A value is taken for a type only if it has its shape.
#include "judge/protocol/convert.hpp"

#include <doctest/doctest.h>

using namespace tumble::judge;

namespace {

struct Pair {
  double first;
  Eigen::Vector3d second;
};

struct Seven {
  double a, b, c, d, e, f, g;
};

struct Twelve {
  double a, b, c, d, e, f, g, h, i, j, k;
  Eigen::Vector3d l;
};

template <class T>
bool refuses(const Value& value) {
  try {
    from_value<T>(value);
    return false;
  } catch (const Malformed&) {
    return true;
  }
}

}  // namespace

TEST_CASE("vectors and matrices are refused with another size") {
  CHECK(refuses<Eigen::Vector3d>(List{1.0, 2.0}));
  CHECK(refuses<Eigen::Vector3d>(List{1.0, 2.0, 3.0, 4.0}));
  CHECK(refuses<Eigen::Vector3d>(1.0));
  CHECK(refuses<Eigen::Vector3d>(List{1.0, 2.0, std::string("3")}));
  CHECK(refuses<Eigen::Matrix2d>(List{List{1.0, 2.0}, List{3.0}}));
  CHECK(refuses<Eigen::MatrixXd>(List{List{1.0, 2.0}, List{3.0}}));
  CHECK(refuses<Eigen::Matrix2d>(List{List{1.0, 2.0}}));
}

TEST_CASE("numbers: an integer can be a real number, not the other way round, nor out of range") {
  CHECK(from_value<double>(std::int64_t{3}) == 3);
  CHECK(refuses<int>(3.0));
  CHECK(refuses<int>(std::int64_t{1} << 40));
  CHECK(refuses<std::size_t>(std::int64_t{-1}));
  CHECK(refuses<double>(std::string("1")));
  CHECK(refuses<std::string>(1.0));
}

TEST_CASE("a matrix is a list of its rows, whatever its storage") {
  Eigen::Matrix<double, 2, 3> m;
  m << 1, 2, 3, 4, 5, 6;
  const Value value = to_value(m);
  CHECK(*list_of(list_of(value)[1])[0].as<double>() == 4);
  CHECK(from_value<Eigen::Matrix<double, 2, 3>>(value) == m);
  CHECK(from_value<Eigen::MatrixXd>(value) == m);
}

TEST_CASE("a struct is a list of its members") {
  const Value value = to_value(Pair{1, {2, 3, 4}});
  CHECK(from_value<Pair>(value).second == Eigen::Vector3d(2, 3, 4));
  CHECK(refuses<Pair>(List{1.0}));
  CHECK(refuses<Pair>(List{1.0, List{2.0, 3.0, 4.0}, 5.0}));
}

TEST_CASE("a struct of up to twelve members keeps them in their order") {
  const Seven seven = from_value<Seven>(to_value(Seven{1, 2, 3, 4, 5, 6, 7}));
  CHECK(seven.a == 1);
  CHECK(seven.g == 7);
  const Value value = to_value(Twelve{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, {12, 13, 14}});
  REQUIRE(list_of(value).size() == 12);
  for (std::size_t i = 0; i < 11; ++i)
    CHECK(*list_of(value)[i].as<double>() == static_cast<double>(i) + 1);
  CHECK(from_value<Twelve>(value).k == 11);
  CHECK(from_value<Twelve>(value).l == Eigen::Vector3d(12, 13, 14));
  CHECK(refuses<Seven>(value));
}
