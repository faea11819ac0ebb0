#!/bin/sh
# Configures and builds with the libraries that CMake fetches, as on a system that packages none of
# them: nothing that is installed is found (FETCHCONTENT_TRY_FIND_PACKAGE_MODE=NEVER).
#
# usage: fetched.sh [--network] FOLDER [TARGET...]
# status: 3 if the sources cannot be had here
#
# With --network CMake downloads the pinned versions, and compares their hashes. Without it, the
# sources come from Debian's source packages, by apt-get and the system's own sources: other versions,
# but the same branch of the build.
set -eu
root=$(CDPATH='' cd -- "$(dirname -- "$0")/../../.." && pwd)
network=no
if [ "${1-}" = --network ]; then network=yes; shift; fi
case ${1-} in
  '' | -*) echo 'usage: fetched.sh [--network] FOLDER [TARGET...]' >&2; exit 2 ;;
esac
mkdir -p "$1"
folder=$(CDPATH='' cd -- "$1" && pwd)
shift
# What uses each of the libraries: Eigen and CLI11; JSON; doctest.
[ $# -gt 0 ] || set -- tumble_tour tumble_scenes tumble_test_main

fail() { echo "fetched.sh: $*" >&2; exit 1; }
no_sources() { echo "fetched.sh: $*" >&2; exit 3; }

# apt-get with the system's own sources, read as sources of source packages, and lists of its own.
write_source_list() {
  for file in /etc/apt/sources.list /etc/apt/sources.list.d/*.list; do
    [ ! -f "$file" ] || sed -n 's/^deb /deb-src /p' "$file"
  done >"$folder/apt/sources.list"
  for file in /etc/apt/sources.list.d/*.sources; do
    [ ! -f "$file" ] ||
      sed 's/^Types:.*/Types: deb-src/' "$file" >"$folder/apt/sources.d/$(basename "$file")"
  done
}
apt() {
  apt-get -q -o "Dir::Etc::SourceList=$folder/apt/sources.list" \
    -o "Dir::Etc::SourceParts=$folder/apt/sources.d" -o "Dir::State::Lists=$folder/apt/lists" "$@"
}

# The folder with the sources of a Debian source package, as upstream has published them.
unpack() { # package
  (cd "$folder/sources" && apt source --only-source --download-only "$1" >/dev/null) ||
    no_sources "the source package $1 cannot be had"
  for archive in "$folder/sources/$1"_*.orig.tar.*; do
    case $archive in *.asc) continue ;; esac
    mkdir -p "$folder/sources/$1"
    tar -x -f "$archive" -C "$folder/sources/$1" --strip-components=1
  done
}

fetch_from_debian() {
  mkdir -p "$folder/apt/sources.d" "$folder/apt/lists/partial" "$folder/sources"
  write_source_list
  apt update >/dev/null 2>&1 || no_sources 'the lists of source packages cannot be read'
  for package in eigen3 cli11 nlohmann-json3 doctest; do unpack "$package"; done
}

set_sources() { # the arguments of cmake that say where the sources are
  for pair in EIGEN3:eigen3 CLI11:cli11 NLOHMANN_JSON:nlohmann-json3 DOCTEST:doctest; do
    echo "-DFETCHCONTENT_SOURCE_DIR_${pair%%:*}=$folder/sources/${pair#*:}"
  done
}

if [ "$network" = no ]; then fetch_from_debian; fi
targets=$*
set -- -S "$root" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DFETCHCONTENT_TRY_FIND_PACKAGE_MODE=NEVER
if [ "$network" = no ]; then
  IFS='
'
  # shellcheck disable=SC2046  # one line an argument
  set -- "$@" $(set_sources)
  unset IFS
fi
cmake "$@"
# shellcheck disable=SC2086  # one word a target
cmake --build "$folder/build" --target $targets

# Nothing that is installed may have been found instead.
if grep -E '^(Eigen3|CLI11|nlohmann_json|doctest)_DIR:PATH=/' "$folder/build/CMakeCache.txt"; then
  fail 'a library that is installed was found'
fi
echo "fetched.sh: built with fetched libraries: $targets"
