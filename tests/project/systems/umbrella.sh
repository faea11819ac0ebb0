#!/bin/sh
# The library's umbrella headers for compilers and targets that no other test has: libc++, C++23,
# wasm32-wasi, no exceptions. And a program of a user who has nothing but -I: without a warning.
# What is not installed is left out, and said; exit status 77 if that is everything.
#
# usage: umbrella.sh [--eigen FOLDER]
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../../.." && pwd)
eigen=
while [ $# -gt 0 ]; do
  case $1 in
    --eigen) eigen=${2:?"--eigen needs the folder that holds Eigen/Core"}; shift 2 ;;
    *) echo "umbrella.sh: there is no option '$1'; usage: umbrella.sh [--eigen FOLDER]" >&2; exit 2 ;;
  esac
done
for folder in /usr/include/eigen3 /usr/local/include/eigen3 /opt/homebrew/include/eigen3; do
  [ -n "$eigen" ] || [ ! -f "$folder/Eigen/Core" ] || eigen=$folder
done
[ -f "$eigen/Eigen/Core" ] || {
  echo "umbrella.sh: Eigen/Core is not in '$eigen'; name its folder with --eigen" >&2
  exit 2
}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
echo '#include <version>' >"$work/probe.cpp"
for header in tumble collide contact; do echo "#include \"tumble/$header.hpp\""; done >"$work/umbrella.cpp"
cat >"$work/plain.cpp" <<'CPP'
#include "umbrella.cpp"
using namespace tumble;
double mass_of(const PolygonMesh& mesh) {
  return mesh_mass_properties(mesh, 1000, {.accuracy = Accuracy::tight}).mass;
}
RigidBodyState<> after_a_second(const RigidBody<>& body, const RigidBodyState<>& start) {
  return simulate(body, start, {.t1 = 1, .tolerance = 1e-9}, Weight{}).end();
}
std::size_t lost(Ensemble& bodies) {
  return advance(bodies, {.h = 0.01, .count = 10}).count + advance(bodies, {.h = 0.01, .count = 10}, Weight{}).count;
}
CPP
cat >"$work/refused.cpp" <<'CPP'
#include "tumble/core/parallel.hpp"
int main() {
  tumble::detail::parallel_for(4, 2, [](int) {});
  tumble::require(false, "the mass is ", -1);
}
CPP
warnings='-Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror'
report() { printf '%-8s %s\n' "$1" "$2" | tee -a "$work/results"; }
works() { # what was tried, and whether it worked
  if [ "$2" = 0 ]; then report passed "$1"; return; fi
  report FAILED "$1"
  sed 's/^/         /' "$work/$lane.messages" | head -n 20
}

# Does the compiler have what these flags ask for?
has() { "$@" -std=c++20 -fsyntax-only "$work/probe.cpp" >/dev/null 2>&1; }

umbrella() {
  has "$@" || { report left-out "$*"; return; }
  status=0
  # shellcheck disable=SC2086  # one word a warning
  "$@" $warnings -I"$root/lib/include" -isystem "$eigen" -fsyntax-only "$work/umbrella.cpp" \
    >"$work/$lane.messages" 2>&1 || status=1
  works "$*" "$status"
}

# What two files of a program would both define, as they include the same headers: all that is not inline.
defined_twice() { nm -C "$1" 2>/dev/null | grep ' [TDBR] tumble::'; }

# A program of a user who has nothing but `-I`: compiled to the end, as some warnings come late.
plain() {
  has "$@" || { report left-out "$* (a program)"; return; }
  status=0
  # shellcheck disable=SC2086  # one word a warning
  "$@" -std=c++20 $warnings -O1 -I"$root/lib/include" -isystem "$eigen" -c "$work/plain.cpp" \
    -o "$work/$lane.o" >"$work/$lane.messages" 2>&1 || status=1
  ! defined_twice "$work/$lane.o" >>"$work/$lane.messages" || status=1
  works "$*: a program without a warning" "$status"
}

# Without exceptions a refusal says why, and aborts.
refused() {
  has "$@" || { report left-out "$* (a refusal)"; return; }
  status=0
  "$@" -std=c++20 -fno-exceptions -pthread -I"$root/lib/include" "$work/refused.cpp" \
    -o "$work/refused" >"$work/$lane.messages" 2>&1 || status=1
  if [ "$status" = 0 ]; then
    # A shell of its own, whose word about the abort goes to the messages, too.
    if sh -c '"$1"; exit $?' sh "$work/refused" >"$work/$lane.messages" 2>&1; then
      status=1
      echo 'it was not refused' >>"$work/$lane.messages"
    fi
    grep -q 'tumble: the mass is -1' "$work/$lane.messages" || status=1
  fi
  works "$* -fno-exceptions: a refusal aborts, with its message" "$status"
}

# C++20 with libstdc++ is what all other tests compile. Two compilers, side by side.
with_gcc() {
  lane=gcc
  plain g++
  umbrella g++ -std=c++23
  umbrella g++ -std=c++20 -fno-exceptions
  umbrella g++ -std=c++20 -DTUMBLE_COMPILED
  refused g++
}
with_clang() {
  lane=clang
  plain clang++
  umbrella clang++ -std=c++20 -stdlib=libc++
  umbrella clang++ -std=c++2b -stdlib=libc++
  umbrella clang++ -std=c++20 --target=wasm32-wasi
  umbrella clang++ -std=c++20 --target=wasm32-wasi -fno-exceptions
}
with_gcc &
with_clang
wait

count() { grep -c "^$1" "$work/results" || :; }
echo "$(count passed) passed, $(count FAILED) failed"
[ "$(count FAILED)" = 0 ] || exit 1
[ "$(count passed)" != 0 ] || exit 77
