/// @file
/// Memory for figures in the browser: pieces of 2^k bytes, which are used again. The C library's is
/// ten times as long, and the C++ library's would bring its messages with it, and a printer for
/// them.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>

#include "tumble/core/require.hpp"

namespace {

/// In front of each piece.
struct alignas(16) Piece {
  Piece* next;      ///< that is free, too
  std::size_t log;  ///< of its size in base 2
};

std::array<Piece*, 32> free_pieces{};
std::uintptr_t begin = 0, end = 0;  // of what no piece was cut from yet

std::uintptr_t cut(std::size_t size) {
  constexpr std::size_t page = 65536;
  if (end - begin < size) {
    const std::size_t pages = (size + page - 1) / page;
    const std::size_t old = __builtin_wasm_memory_grow(0, pages);
    tumble::require(old != SIZE_MAX, "this figure has no memory left");
    if (old * page != end) begin = old * page;
    end = (old + pages) * page;
  }
  begin += size;
  return begin - size;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
  const auto log = static_cast<std::size_t>(std::bit_width((size < 16 ? 16 : size) - 1));
  tumble::require(log < free_pieces.size(), "this figure asks for too much memory");
  Piece* piece = free_pieces[log];
  if (piece)
    free_pieces[log] = piece->next;
  else
    piece = new (reinterpret_cast<void*>(cut(sizeof(Piece) + (std::size_t{1} << log)))) Piece;
  *piece = {nullptr, log};
  return piece + 1;
}

void free(void* memory) {
  if (!memory) return;
  Piece* const piece = static_cast<Piece*>(memory) - 1;
  piece->next = free_pieces[piece->log];
  free_pieces[piece->log] = piece;
}

void* calloc(std::size_t count, std::size_t size) {
  return std::memset(malloc(count * size), 0, count * size);
}

void* realloc(void* memory, std::size_t size) {
  void* const larger = malloc(size);
  if (memory) {
    const std::size_t old = std::size_t{1} << (static_cast<Piece*>(memory) - 1)->log;
    std::memcpy(larger, memory, old < size ? old : size);
  }
  free(memory);
  return larger;
}
}

void* operator new(std::size_t size) { return malloc(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return malloc(size); }
void operator delete(void* memory) noexcept { free(memory); }
void operator delete(void* memory, std::size_t) noexcept { free(memory); }

// What wants to lie at a multiple of more than 16: the piece's own place is in front of it.
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::uintptr_t>(alignment);
  void* const piece = malloc(size + step + sizeof(void*));
  const std::uintptr_t after = reinterpret_cast<std::uintptr_t>(piece) + sizeof(void*);
  void** const place = reinterpret_cast<void**>((after + step - 1) / step * step);
  place[-1] = piece;
  return place;
}
void operator delete(void* memory, std::align_val_t) noexcept {
  if (memory) free(static_cast<void**>(memory)[-1]);
}
void operator delete(void* memory, std::size_t, std::align_val_t alignment) noexcept {
  operator delete(memory, alignment);
}
