// Which other software was found when this was configured.
#include "project/bench/mass/case.hpp"

namespace tumble::bench {

std::vector<Method> peers() {
  std::vector<Method> methods;
#ifdef TUMBLE_HAS_CGAL
  add_cgal(methods);
#endif
#ifdef TUMBLE_HAS_LIBIGL
  add_libigl(methods);
#endif
#ifdef TUMBLE_HAS_VOLINT
  add_volint(methods);
#endif
#ifdef TUMBLE_HAS_MUJOCO
  add_mujoco(methods);
#endif
#ifdef TUMBLE_HAS_BULLET
  add_bullet(methods);
#endif
#ifdef TUMBLE_HAS_ODE
  add_ode(methods);
#endif
  return methods;
}

}  // namespace tumble::bench
