// The mesh loader from an installed prefix: it must compile and link.
#include <cstdio>
#include <sstream>
#include <tumble/mesh/read_obj.hpp>

int main() {
  std::istringstream triangle("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  std::printf("%d face\n", tumble::read_obj(triangle, "triangle").face_count());
}
