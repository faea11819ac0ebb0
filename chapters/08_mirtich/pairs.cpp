/// @file
/// What rounding loses of a sum and of a product.

#include "common.hpp"
#include "parts.hpp"
#include "plain_pairs.hpp"

namespace mirtich_chapter {

Table pairs_table() {
  Table table({"exactly", "rounded", "what the rounding lost"});
  const auto add = [&](const std::string& what, const TwoDoubles& pair) {
    table.add({what, number(pair.value, 17), number(pair.lost, 4)});
  };
  add("1 + 1e-20", two_sum(1, 1e-20));
  add("0.1 + 0.2", two_sum(0.1, 0.2));
  add("0.1 × 0.1", two_prod(0.1, 0.1));
  add("3 × 0.25", two_prod(3, 0.25));
  return table;
}

}  // namespace mirtich_chapter
