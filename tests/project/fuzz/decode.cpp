/// @file
/// libFuzzer on what the judge reads from a worker: no bytes may crash it, hang it or make it take
/// more memory than they are worth, and what it takes for a message it writes back the same.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "judge/protocol/convert.hpp"
#include "judge/protocol/message.hpp"
#include "judge/verdict/number_text.hpp"

using namespace tumble::judge;

namespace {

/// What a spec may ask of an answer: every shape is either taken or refused.
template <class T>
void read_as(const Value& value) {
  try {
    from_value<T>(value);
  } catch (const Malformed&) {
  }
}

void read_in_every_shape(const Value& value) {
  read_as<double>(value);
  read_as<int>(value);
  read_as<std::string>(value);
  read_as<Eigen::Vector3d>(value);
  read_as<Eigen::VectorXd>(value);
  read_as<Eigen::Matrix3d>(value);
  read_as<Eigen::MatrixXd>(value);
  read_as<std::vector<Eigen::Vector3d>>(value);
  if (text_of(value, 17).size() > 1 << 20) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  try {
    const Message message = decode(bytes);
    const std::string canonical = encode(message);
    if (encode(decode(canonical)) != canonical) std::abort();
    for (const Value& value : message.content) read_in_every_shape(value);
  } catch (const BadMessage&) {
  }
  return 0;
}
