#include "judge/class/shard.hpp"

#include <algorithm>
#include <charconv>

#include "judge/class/file_names.hpp"
#include "judge/course/stable_hash.hpp"
#include "tumble/core/require.hpp"

namespace tumble::judge {

namespace {

constexpr std::size_t most_shards = 10'000;

/// A whole number and nothing else; 0 if it is none.
std::size_t whole_number(const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? number : 0;
}

}  // namespace

Shard shard_in(const std::string& text) {
  const std::size_t slash = std::min(text.find('/'), text.size());
  const Shard shard{whole_number(text.substr(0, slash)),
                    whole_number(text.substr(std::min(slash + 1, text.size())))};
  require(shard.number > 0 && shard.of > 0, "'", escaped(text),
          "' is not a shard: 3/10 is the third of ten, and 1/10 the first");
  require(shard.of <= most_shards, "'", text, "' is one of more than ", most_shards, " shards");
  require(shard.number <= shard.of, "'", text, "': of ", shard.of, " shards the last is ", shard.of,
          "/", shard.of);
  return shard;
}

std::string name_of(const Shard& shard) {
  return std::to_string(shard.number) + "/" + std::to_string(shard.of);
}

std::size_t shard_number(const std::string& student, std::size_t of) {
  const std::uint64_t hash = stable_hash(student);
  return static_cast<std::size_t>((hash ^ (hash >> 32)) % of) + 1;
}

}  // namespace tumble::judge
