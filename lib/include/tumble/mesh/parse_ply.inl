#pragma once

#include "tumble/mesh/parse_ply.hpp"

#include <array>

#include "tumble/core/compiled.hpp"
#include "tumble/mesh/ply_bytes.hpp"
#include "tumble/mesh/ply_text.hpp"

namespace tumble::detail {

TUMBLE_BODY PolygonMesh parse_ply(std::string_view bytes, std::string_view name) {
  detail::TextScanner text(bytes, name);
  const detail::PlyHeader header = detail::PlyHeaderReader(text).read();
  if (header.format == detail::PlyFormat::ascii)
    return detail::PlyBodyReader(header, detail::PlyText(text), name).read();
  const bool little = header.format == detail::PlyFormat::little_endian;
  const auto order = little ? detail::ByteOrder::little : detail::ByteOrder::big;
  const std::size_t begin = bytes.size() - text.bytes_left();
  return detail::PlyBodyReader(header, detail::PlyBytes(bytes, begin, order, name), name).read();
}

}  // namespace tumble::detail
