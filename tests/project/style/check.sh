#!/bin/sh
# The tree keeps its style: clang-format over every C++ file, shellcheck over every script, and clang-tidy
# over one translation unit per part (.clang-tidy says which checks are off, and why). Each finding is an
# error. What is not installed is left out, and said; exit status 77 if that is everything.
#
# usage: check.sh [BUILD]    the folder of a configured preset (default: build/dev), for the compiler's flags
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../../.." && pwd)
build=${1:-$root/build/dev}
cd "$root"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# check NAME COMMAND...: runs it; of a failure, what it says.
check() {
  name=$1
  shift
  if "$@" >"$work/$name" 2>&1; then
    echo "passed  $name"
    : >"$work/$name.passed"
    return
  fi
  echo "FAILED  $name"
  : >"$work/$name.failed"
  grep -v 'warnings generated\|Suppressed\|Use -header-filter' "$work/$name" | head -n 60
}

# Every check below asks git for its files: of none, each would pass.
[ -n "$(git ls-files '*.cpp')" ] || {
  echo "check.sh: git knows no files in $root; is it a clone?" >&2
  exit 2
}

have() { command -v "$1" >/dev/null 2>&1 || { echo "left out: $1 is not installed"; return 1; }; }

# Submissions are as their authors would write them.
formatted() { git ls-files '*.hpp' '*.inl' '*.cpp' | grep -v '^tests/project/attacks/' | xargs clang-format --dry-run -Werror; }

# By the first line: a page may quote a script.
scripts() { git ls-files | xargs awk 'FNR == 1 && /^#!\/bin\/(ba)?sh/ { print FILENAME } { nextfile }' | xargs shellcheck; }

# tidy NAME FILE...: these files as one translation unit. What copies too much is looked for in the library
# alone: among a hundred files that check takes as long as all others together.
tidy() {
  part=$1
  shift
  for file in "$@"; do echo "#include \"$root/$file\""; done >"$work/$part.cpp"
  off=-bugprone-suspicious-include
  [ "$part" = library ] || off=$off,-performance-unnecessary-value-param
  # Warnings are the compiler's own business: here is what it sees, without what only gcc knows.
  clang-tidy --quiet --config-file="$root/.clang-tidy" --checks="$off" \
    "$work/$part.cpp" -- -std=gnu++20 -Wno-everything \
    -DEIGEN_DONT_VECTORIZE -DTUMBLE_COURSE='""' \
    -I"$root/tests" -I"$root/exercises" -I"$root/chapters" -I"$root/lib" -I"$root/lib/include" \
    -isystem "$eigen"
}

have clang-format && check clang-format formatted
have shellcheck && check shellcheck scripts
if have clang-tidy; then
  eigen=$(sed -n 's/^Eigen3_DIR:PATH=\(.*\)\/share\/eigen3\/cmake$/\1\/include\/eigen3/p' "$build/CMakeCache.txt")
  sources() { git ls-files "$@" | grep '\.cpp$' | grep -v '_none\.cpp$\|spec/doctest\.cpp$\|class/unpack\.cpp$\|class/pack\.cpp$\|mine/student/.*\.cpp$\|judge/page/\(main\|page_worker\|load_spec\|student/.*\)\.cpp$'; }
  # Two at a time, of about the same length.
  # shellcheck disable=SC2046  # one word a file: their names have no spaces
  {
    check judge tidy judge $(sources tests/judge | grep -v 'judge/\(commands\|mine\|worker\)/')
    check worker tidy worker $(sources tests/judge/worker)
    check scenes tidy scenes $(sources chapters/scenes)
    check book tidy book $(sources chapters/book/tool)
  } &
  check library tidy library lib/include/tumble/tumble.hpp lib/include/tumble/collide.hpp lib/include/tumble/contact.hpp
  # shellcheck disable=SC2046
  check commands tidy commands $(sources tests/judge/commands tests/judge/mine)
  wait
fi
count() { find "$work" -name "*.$1" | wc -l; }
echo "$(count passed) passed, $(count failed) failed"
[ "$(count failed)" = 0 ] || exit 1
[ "$(count passed)" != 0 ] || exit 77
