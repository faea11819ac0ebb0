#pragma once

#include "tumble/collide/first_meeting.hpp"
#include "tumble/core/compiled.hpp"

namespace tumble::collide::detail {

TUMBLE_BODY bool stay_in_touch(int looks, double parting, double speed) {
  constexpr int few = 100, most = 100'000;
  constexpr double least = 4. / most;  // of the speed
  return looks >= most || (looks >= few && parting < least * speed);
}

}  // namespace tumble::collide::detail
