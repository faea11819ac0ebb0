// A part of the library is enough to see that it is found: ../downstream compiles the whole.
#include <tumble/mass/solids/box.hpp>
#include <tumble/version.hpp>

int main() {
  const tumble::Box bar{{0.1, 0.2, 0.05}};  // [m]
  return tumble::mass_properties(bar, 1000).mass > 0.99 ? 0 : 1;
}
