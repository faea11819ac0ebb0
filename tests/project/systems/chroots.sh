#!/bin/sh
# The library and the tree on other releases of Debian: each gets a folder with a system of its own
# (debootstrap), the packages, a copy of this tree, and the steps; a table at the end says how each
# went. Root is needed. The logs stay in the folder.
#
# usage: chroots.sh [OPTIONS] FOLDER SUITE...        such as: chroots.sh /var/tmp/roots trixie sid
#
#   --steps LIST     of: umbrella tour configure build test   (default: "umbrella tour configure")
#   --compilers LIST of: gcc clang                            (default: "gcc clang")
#   --preset NAME    what configure, build and test use       (default: dev)
#   --jobs N         compilers at the same time               (default: 1)
#   --mirror URL     where Debian is (default: the first one of the system's own sources)
#   --stale          accept a mirror's list after its date (sid's is valid for a week); signatures
#                    are checked all the same
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../../.." && pwd)
steps='umbrella tour configure' compilers='gcc clang' preset=dev jobs=1 mirror='' stale=''
packages='g++ clang cmake ninja-build git ca-certificates libeigen3-dev doctest-dev libcli11-dev
  nlohmann-json3-dev libarchive-dev libseccomp-dev libutf8proc-dev libc++-dev libc++abi-dev wasi-libc
  libc++-dev-wasm32'

fail() { echo "chroots.sh: $*" >&2; exit 1; }

while [ $# -gt 0 ]; do
  case $1 in
    --stale) stale='-o Acquire::Check-Valid-Until=false'; shift; continue ;;
    --steps | --compilers | --preset | --jobs | --mirror) [ $# -gt 1 ] || fail "$1 needs a value" ;;
    -*) fail "there is no option '$1'" ;;
    *) break ;;
  esac
  case $1 in
    --steps) steps=$2 ;;
    --compilers) compilers=$2 ;;
    --preset) preset=$2 ;;
    --jobs) jobs=$2 ;;
    --mirror) mirror=$2 ;;
  esac
  shift 2
done
[ $# -gt 1 ] || fail 'usage: chroots.sh [OPTIONS] FOLDER SUITE...'
[ "$(id -u)" = 0 ] || fail 'root is needed for debootstrap and chroot'
command -v debootstrap >/dev/null || fail 'debootstrap is needed: apt-get install debootstrap'
mkdir -p "$1"
folder=$(CDPATH='' cd -- "$1" && pwd)
shift

# The first mirror that the system itself uses.
if [ -z "$mirror" ]; then
  mirror=$(cat /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list 2>/dev/null |
    sed -n -e 's/^URIs: *\([^ ]*\).*/\1/p' -e 's/^deb \(\[[^]]*\] \)\{0,1\}\([^ ]*\).*/\2/p' |
    head -n 1)
fi
[ -n "$mirror" ] || fail 'which mirror? --mirror URL'

# A suite's system, with its packages; made once. What was broken off half-way has another name.
make_system() { # suite
  system=$folder/$1
  if [ ! -d "$system" ]; then
    rm -rf "$system.part"
    debootstrap --variant=minbase "$1" "$system.part" "$mirror" && mv "$system.part" "$system" || return 1
  fi
  cp /etc/resolv.conf "$system/etc/resolv.conf" || return 1
  # shellcheck disable=SC2086  # words: an option, packages
  chroot "$system" apt-get -q $stale update &&
    chroot "$system" env DEBIAN_FRONTEND=noninteractive \
      apt-get -q install -y --no-install-recommends $packages
}

# The tree as it is here, without what was built of it, and without what was built there before.
copy_tree() { # suite compiler
  tree=$folder/$1/tumble-$2
  rm -rf "$tree"
  mkdir -p "$tree"
  (cd "$root" && tar -c --exclude=./build --exclude=./results --exclude=./.git .) | tar -x -C "$tree"
}

command_of() { # step
  case $1 in
    umbrella) echo 'tests/project/systems/umbrella.sh' ;;
    tour) echo './tumble tour' ;;
    configure) echo "cmake --preset $preset" ;;
    build) echo "cmake --build --preset $preset" ;;
    test) echo "ctest --preset $preset -j $jobs" ;;
    *) echo "chroots.sh: there is no step '$1'" >&2; return 1 ;;
  esac
}

run_step() { # suite compiler step
  case $2 in gcc) cxx=g++ ;; clang) cxx=clang++ ;; *) fail "there is no compiler '$2'" ;; esac
  command=$(command_of "$3") || exit 1
  log=$folder/$1-$2-$3.log
  began=$(date +%s)
  result=passed
  chroot "$folder/$1" env CXX="$cxx" CMAKE_BUILD_PARALLEL_LEVEL="$jobs" HOME=/root LC_ALL=C.UTF-8 \
    sh -c "cd '/tumble-$2' && $command" >"$log" 2>&1 || result=FAILED
  warnings=$(grep -c 'warning:' "$log" || true)
  row "$1" "$2" "$3" "$(($(date +%s) - began))" "$warnings" "$result"
}

row() { printf '%-10s %-8s %-10s %8s %9s  %s\n' "$@" | tee -a "$folder/table.txt"; }

: >"$folder/table.txt"
row suite compiler step seconds warnings result
for suite; do
  if ! make_system "$suite" >"$folder/$suite-system.log" 2>&1; then
    row "$suite" - system - - FAILED
    continue
  fi
  for compiler in $compilers; do
    copy_tree "$suite" "$compiler"
    for step in $steps; do run_step "$suite" "$compiler" "$step"; done
  done
  chroot "$folder/$suite" sh -c 'g++ --version | head -n 1; clang++ --version | head -n 1
    cmake --version | head -n 1; dpkg-query -W libeigen3-dev' | sed "s/^/  $suite: /"
done
! grep -q FAILED "$folder/table.txt"
