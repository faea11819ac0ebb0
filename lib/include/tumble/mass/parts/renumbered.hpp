#pragma once
/// @file
/// Findings about a part of a mesh, with the numbers that faces and vertices have in the whole.

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

namespace tumble::detail {

/// Whether a number sign behind some words is before a vertex: they say what it counts, as in
/// "edge #3–#7 of the faces #1 and #2".
bool counts_vertices(std::string_view words);

/// The message with other numbers behind its number signs.
/// @param face   what is there instead, of the index of a face from 0
/// @param vertex the same of a vertex
template <class FaceText, class VertexText>
std::string renumbered(const std::string& message, const FaceText& face, const VertexText& vertex) {
  std::string text;
  for (std::size_t at = 0; at < message.size();) {
    const std::size_t sign = std::min(message.find('#', at), message.size());
    text += message.substr(at, sign - at);
    if (sign == message.size()) break;
    int number = 0;
    const char* const digits = message.data() + sign + 1;
    const char* const end = std::from_chars(digits, message.data() + message.size(), number).ptr;
    text += "#" + (counts_vertices(std::string_view(message).substr(0, sign)) ? vertex(number - 1)
                                                                              : face(number - 1));
    at = static_cast<std::size_t>(end - message.data());
  }
  return text;
}

}  // namespace tumble::detail

#ifndef TUMBLE_COMPILED
#include "tumble/mass/parts/renumbered.inl"
#endif
