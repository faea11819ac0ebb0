#!/bin/sh
# The script ./tumble by itself: nothing is built here. Tools that only pretend stand before the
# system's own, and a tree that has what the script reads, at a path with spaces and an umlaut.
# usage: script.sh ROOT [SHELL]: the tree, and the shell that runs its script
set -u
root=$1 shell=${2:-sh}
unset CXX TUMBLE_BUILD
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree="$work/Übung 1 (copy)"
bin=$work/bin
wrong=0

mkdir -p "$tree/tests/project" "$bin" "$work/elsewhere"
cp "$root/tumble" "$root/CMakeLists.txt" "$tree"
for contract in "$root"/exercises/[0-9]*/contract.hpp; do
  chapter=$(basename "$(dirname "$contract")")
  mkdir -p "$tree/exercises/$chapter" "$tree/chapters/$chapter"
  cp "$contract" "$tree/exercises/$chapter"
done

# pretend NAME: a tool that does what stdin says.
pretend() {
  { echo '#!/bin/sh'; cat; } >"$bin/$1"
  chmod +x "$bin/$1"
}

pretend cmake <<'STUB'
[ "${1-}" != --version ] || { echo "cmake version ${CMAKE_IS:-3.25.1}"; exit; }
echo "cmake $*" >>"$CALLS"
while [ $# -gt 0 ]; do
  if [ "$1" = -B ]; then echo "${SERVER-build tumble_serve}" >"$2/build.ninja"; echo "CMAKE_CXX_COMPILER:FILEPATH=$(command -v c++)" >"$2/CMakeCache.txt"; fi
  shift
done
STUB
pretend ninja <<'STUB'
folder=$2
shift 2
echo "ninja $*" >>"$CALLS"
case $* in
  tumble_judge*any_spec | tumble_judge)
    mkdir -p "$folder/tests/judge"
    cp "$JUDGE" "$folder/tests/judge/tumble_judge" ;;
  book)
    mkdir -p "$folder/book/html" "$folder/chapters/book"
    : >"$folder/book/html/index.html"
    { echo '#!/bin/sh'; echo 'echo "tumble_book $*" >>"$CALLS"'; } >"$folder/chapters/book/tumble_book"
    chmod +x "$folder/chapters/book/tumble_book" ;;
  tumble_serve)
    mkdir -p "$folder/chapters/book"
    { echo '#!/bin/sh'; echo 'echo "serve: $*"'; } >"$folder/chapters/book/tumble_serve"
    chmod +x "$folder/chapters/book/tumble_serve" ;;
  tumble_tour)
    if [ -n "${NINJA_FAILS:-}" ]; then
      echo '[1/9] 0.5 Building a'
      echo 'FAILED: b.o'
      echo 'c++ -c the/command'
      echo 'b.cpp:1: error: what is wrong'
      echo '[2/9] 9.0 Building c'
      echo 'ninja: build stopped: subcommand failed.'
      exit 1
    fi
    if [ -n "${NINJA_TAKES_MINUTES:-}" ]; then
      for step in '1/200] 2.0' '2/200] 11.0' '22/200] 15.5' '23/200] 16.0' '24/200] 75.9' \
        '45/200] 84.0' '46/200] 86.0' '200/200] 300.1'; do echo "[$step Building"; done
    else
      echo '[1/4] 0.5 Building a'
      echo '[4/4] 7.9 Linking b'
    fi
    mkdir -p "$folder/chapters"
    { echo '#!/bin/sh'; echo 'echo "tour: $*"; exit ${TOUR_STATUS:-0}'; } >"$folder/chapters/tumble_tour"
    chmod +x "$folder/chapters/tumble_tour" ;;
esac
STUB
pretend c++ <<'STUB'
case $* in
  *--version*) [ -z "${COMPILER_IS_A_STUB:-}" ] ;;
  *) echo "#define __GNUC__ ${GCC_IS:-12}" ;;
esac
STUB
cp "$bin/c++" "$bin/other-c++"
pretend dpkg-query <<'STUB'
for each in "$@"; do
  case $each in -* | "${ABSENT:-none}") ;; *) echo "$each install ok installed" ;; esac
done
STUB
pretend id <<'STUB'
echo "${ID:-0}"
STUB
pretend apt-get <<'STUB'
echo "apt-get $*" >>"$CALLS"
[ -z "${APT_FAILS:-}" ]
STUB
pretend sudo <<'STUB'
echo "sudo $*" >>"$CALLS"
exit 1
STUB
pretend ctest <<'STUB'
echo "ctest $*" >>"$CALLS"
exit ${CTEST_STATUS:-0}
STUB
cat >"$work/judge" <<'STUB'
#!/bin/sh
case $1-$2-${3-} in
  --parts-grade-*) echo tumble_judge_grading ;;
  --parts-*) ;;
  --needs-check-4.1) echo spec.04_quaternions.product ;;
  --needs-check-4) printf '%s\n' spec.04_quaternions.product spec.04_quaternions.inverse ;;
  --needs-stubs-) echo all_specs ;;
  --needs-*) ;;
  *) echo "judge: $*"; exit 1 ;;
esac
STUB
chmod +x "$work/judge"
export CALLS="$work/calls" JUDGE="$work/judge"

# run ARGUMENT...: what it prints into $output, its status into $status.
run() {
  : >"$CALLS"
  output=$(cd "$work/elsewhere" && PATH="$bin:$PATH" $shell "$tree/tumble" "$@" 2>&1)
  status=$?
}

fresh() { rm -rf "$tree/build"; }

complain() {
  printf '%s: %s\nstatus %s: %s\n' "$what" "$1" "$status" "$output"
  wrong=1
}

# expect STATUS TEXT...: each of them is in the output.
expect() {
  [ "$status" = "$1" ] || complain "the status should be $1"
  shift
  for text in "$@"; do
    case $output in *"$text"*) ;; *) complain "should say '$text'" ;; esac
  done
}

expect_no() { case $output in *"$1"*) complain "should not say '$1'" ;; esac; }

# called TEXT: one of the tools was called so.
called() { grep -qF -e "$1" "$CALLS" || complain "should call '$1', calls $(cat "$CALLS")"; }

called_nothing() { [ ! -s "$CALLS" ] || complain "should call nothing, calls $(cat "$CALLS")"; }

what='help and version'
run
expect 0 'usage: ./tumble' 'exit status:' 'matrix'
for arguments in --help -h help '--no-install --help'; do
  # shellcheck disable=SC2086  # several words
  run $arguments
  expect 0 'usage: ./tumble [--no-install] COMMAND'
  called_nothing
done
for command in chapter book bench test completion prepare; do
  for arguments in "$command --help" "--help $command" "help $command" "$command --no-install -h"; do
    # shellcheck disable=SC2086
    run $arguments
    expect 0 "usage: ./tumble $command"
    called_nothing
  done
done
# All that the programs behind them take is in their help and in what a shell completes.
options_in() { grep -o '_\(option\|flag\)("--[a-z-]*' "$1" | sed 's/.*"//'; }
for what in mass dynamics contact judge; do
  main=$root/tests/project/bench/$what/main.cpp
  run bench --help
  # shellcheck disable=SC2046  # several words
  expect 0 $(options_in "$main")
  # shellcheck disable=SC2046
  expect 0 $(sed -n 's/.*IsMember({\(.*\)}).*/\1/p' "$main" | tr -d '",')
  run completion words bench "$what"
  # shellcheck disable=SC2046
  expect 0 $(options_in "$main")
done
for arguments in 'chapter --help' 'completion words chapter'; do
  # shellcheck disable=SC2086
  run $arguments
  # shellcheck disable=SC2046
  expect 0 $(options_in "$root/lib/support/chapter.cpp")
done
what='help'
run bench mass --quick --help
expect 0 'usage: ./tumble bench'
run --version
expect 0 "tumble $(sed -n 's/^project(tumble VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")"

what='wrong usage'
run chekc 4.1
expect 2 "tumble: there is no command 'chekc'; did you mean check?"
run xyzzy
expect 2 "there is no command 'xyzzy'; there are: tour chapter"
run bench mas
expect 2 'did you mean mass?'
run bench
expect 2 'mass, dynamics, contact, judge'
run test dve
expect 2 'did you mean dev?'
run chapter
expect 2 'tumble: which chapter?'
run chapter 04_quaternion
expect 2 'did you mean 04_quaternions?'
run book --wirte
expect 2 'did you mean --write?'
run completion fish
expect 2 "there is no shell 'fish'"
called_nothing

what='the exercises in the book, served'
for each in emcc npm; do pretend $each </dev/null; done
pretend node <<'STUB'
echo "node $*" >>"$CALLS"
STUB
run book --exercises --no-open
expect 2 'exercises in a page need the solutions'
mkdir "$tree/solutions"
ABSENT=zstd run book --no-install --exercises
expect 2 'exercises in the page need emscripten (112 MB to download), node, npm and zstd' 'missing: zstd'
called_nothing
pretend emcmake <<'STUB'
echo "emcmake $*" >>"$CALLS"
mkdir -p "${5:?}"
: >"$5/build.ninja"
STUB
run book --exercises --no-open
expect 0 "$tree/build/release/book/html/index.html"
called "emcmake cmake -S $tree/tests/judge/page -B $tree/build/page/judge -G Ninja"
called "node $tree/tests/judge/page/build/make.mjs --judge $tree/build/page/judge --out $tree/build/page/site"
called 'ninja book'
called "tumble_book --root $tree exercises $tree/build/release/book/html $tree/build/page/site"
run book --serve --no-open --port 8123
expect 0 "serve: $tree/build/release/book/html --port 8123"
if grep -q 'ninja book' "$CALLS"; then complain 'the site that is there is served as it is'; fi
run book --serve
expect 0 "serve: $tree/build/release/book/html --port 0"
run book --exercises --serve --no-open
expect 0 "serve: $tree/build/release/book/html --port 0"
called "exercises $tree/build/release/book/html"
rm -r "$tree/build/release/book"
run book --serve --no-open
expect 0 serve
called 'ninja book'
rm -r "$tree/build"
SERVER='' run book --serve --no-open
expect 2 'tumble: please install: cpp-httplib' 'libcpp-httplib-dev'
run book --serve --no-open
expect 0 'serve: ' # installed meanwhile: configured again
run book --port
expect 2 'tumble: --port needs a number'
run book --port=high
expect 2 "tumble: --port needs a number, not 'high'"
run book --pdf --serve
expect 2 'tumble: --pdf goes with neither --exercises nor --serve'
rmdir "$tree/solutions"
for each in emcc npm emcmake node; do rm "$bin/$each"; done
fresh

what='the book on paper'
pretend chromium <<'STUB'
echo "chromium $*" >>"$CALLS"
[ -z "${CHROMIUM_FAILS:-}" ] || { echo 'no fonts'; exit 1; }
for argument in "$@"; do
  case $argument in --print-to-pdf=*) echo '%PDF' >"${argument#*=}" ;; esac
done
STUB
run book --pdf
expect 0 "$tree/build/release/book/tumble.pdf"
called 'ninja book'
called "--no-sandbox"
called "file://$tree/build/release/book/html/print.html"
ID=1000 run book --pdf
expect 0 tumble.pdf
if grep -q no-sandbox "$CALLS"; then complain 'without root the sandbox stays'; fi
CHROMIUM_FAILS=yes run book --pdf
expect 2 'no fonts' 'tumble: printing the PDF failed, see above'
rm "$bin/chromium"
mkdir -p "$work/tools"
for each in sh sed grep cat mkdir rm dirname basename awk tr id; do ln -sf "$(command -v "$each")" "$work/tools/$each"; done
: >"$CALLS"
output=$(PATH="$work/tools" "$(command -v "$shell")" "$tree/tumble" book --pdf 2>&1)
status=$?
expect 2 'a PDF is printed by Chromium or Chrome, and neither is installed here'
called_nothing
fresh

what='a link on PATH'
ln -s "$tree/tumble" "$work/link"
ln -s ../link "$bin/tumble"
output=$(cd "$work/elsewhere" && PATH="$bin:$PATH" tumble --version 2>&1)
status=$?
expect 0 'tumble '

what='building and running'
run tour --mesh 'a b.obj'
expect 0 'tumble: configuring' 'tumble: building the tour, 4 steps' 'tumble: built the tour in 7 s' 'tour: --mesh a b.obj'
called "cmake --preset release -B $tree/build/release"
run tour
expect_no configuring
TOUR_STATUS=1 run tour --no-install
expect 1 'tour: '
expect_no '--no-install'
what='a long build in a log: a line now and then'
NINJA_TAKES_MINUTES=yes run tour
expect 0 'tumble: building the tour, 200 steps' 'tumble: building the tour [22/200], about 2 min left' \
  'tumble: building the tour [24/200], about 9 min left' 'tumble: built the tour in 300 s'
for count in 2 23 45; do expect_no "[$count/200]"; done # ten seconds and a tenth, or a minute
expect 0 'tumble: building the tour [46/200], about 5 min left'
what='building and running'
NINJA_FAILS=yes run tour
expect 2 'error: what is wrong' 'tumble: building the tour failed'
expect_no 'the/command'

what='what the judge needs'
run check 4.1 --no-install
expect 1 'judge: check 4.1'
called 'ninja tumble_judge any_spec'
called 'ninja spec.04_quaternions.product'
run check 4
called 'ninja spec.04_quaternions.product spec.04_quaternions.inverse'
run stubs
called 'ninja all_specs'
for arguments in list matrix sandbox 'check --help' '--help check' 'help check'; do
  # shellcheck disable=SC2086
  run $arguments
  [ "$(grep -c ninja "$CALLS")" = 1 ] || complain 'should build the judge alone'
done
expect 1 'judge: check --help'
run grade .
called 'ninja tumble_judge any_spec'
called 'ninja tumble_judge_grading'
run check --from . 4.1
expect 1 'judge: check --from . 4.1'
run grade . --from moodle
expect 1 'judge: grade . --from moodle'
run grade . --only 1.1 1.2 --out nowhere --strict
expect 1 'judge: grade . --only 1.1 1.2'
for arguments in 'grade nowhere' 'grade --out x nowhere' 'grade --strict nowhere --jobs 2' 'grade --merge nowhere' \
  'grade --merge . nowhere' 'check 4.1 --from nowhere' 'check --from=nowhere' 'mine --fill --from nowhere'; do
  # shellcheck disable=SC2086
  run $arguments
  expect 2 'there is no folder nowhere'
  [ ! -s "$CALLS" ] || complain 'should build nothing'
done
for arguments in 'grade . --course nowhere.json' 'grade . --roster=nowhere.json' 'handout --course nowhere.json x'; do
  # shellcheck disable=SC2086
  run $arguments
  expect 2 'there is no file nowhere.json'
  [ ! -s "$CALLS" ] || complain 'should build nothing'
done
run prepare
expect 0
called 'ninja tumble_judge all_specs'
run prepare check 4.1
expect 0
called 'ninja spec.04_quaternions.product'
run prepare everything
expect 2 "not 'everything'"

what='TUMBLE_BUILD, and a tree that cannot be written to'
fresh
TUMBLE_BUILD="$work/build here" run tour
expect 0 'tour:'
called "-B $work/build here/release"
[ ! -e "$tree/build" ] || complain 'should leave the tree alone'
TUMBLE_BUILD=relative run tour
called "-B $work/elsewhere/relative/release"
: >"$tree/build"
run tour
expect 2 'cannot write into' "TUMBLE_BUILD=\$HOME/tumble-build ./tumble tour"
fresh

what='another compiler'
run tour
CXX=other-c++ run tour
expect 0 'configuring for' 'other-c++'
called '--fresh'
CXX=other-c++ run tour
expect_no configuring
run tour
expect_no configuring
CXX=no-such-compiler run tour
expect 2 "CXX is 'no-such-compiler': there is no such compiler"
called_nothing

what='too old'
fresh
CMAKE_IS=3.22.1 GCC_IS=11 run tour
expect 2 'CMake 3.25 or newer is needed, this is 3.22' 'gcc 12 or newer is needed, this is 11' 'CXX=g++-12 ./tumble tour'
CMAKE_IS=4.0.0 run tour
expect 0

what='what is missing'
fresh
ABSENT=doctest-dev run tour
expect 0 'installing: doctest-dev'
called 'DPkg::Lock::Timeout=120 install -y --no-install-recommends doctest-dev'
ABSENT=doctest-dev run --no-install tour
expect 2 'tumble: missing: doctest-dev'
called_nothing
ABSENT=doctest-dev run tour --no-install
expect 2 'tumble: missing: doctest-dev'
ID=1000 ABSENT=doctest-dev run tour
expect 0 'could not be installed' 'sudo apt-get install doctest-dev' 'CMake fetches' 'tour:'
called 'sudo apt-get'
ID=1000 ABSENT=doctest-dev run tour
expect 0
expect_no doctest-dev
ID=1000 ABSENT=doctest-dev run tour --no-install
expect 0
ID=1000 COMPILER_IS_A_STUB=yes run tour
expect 2 'please install: a C++20 compiler' 'sudo apt-get install g++'
expect_no tinyobj

what='tests'
run test
expect 0 'tests with preset dev'
called 'ninja all'
called "ctest --preset dev --test-dir $tree/build/dev"
run test long
expect 0 'tests with preset long'
called "ctest --preset long --test-dir $tree/build/dev"
CTEST_STATUS=8 run test
expect 1

what='completion'
run completion words
expect 0 check completion --version
run completion words check
expect 0 4.1 product all --seed
run completion words export
expect 0 gradescope
called_nothing
for shell_name in bash zsh; do
  command -v "$shell_name" >/dev/null || continue
  run completion "$shell_name"
  printf '%s\n' "$output" >"$work/completion"
  "$shell_name" -n "$work/completion" || complain "$shell_name does not understand it"
done
if command -v bash >/dev/null; then
  run completion bash
  printf '%s\n' "$output" >"$work/completion"
  # shellcheck disable=SC2016  # bash expands it
  output=$(bash -c '. "$1"; COMP_WORDS=("$2" check prod); COMP_CWORD=2; _tumble; echo "${COMPREPLY[*]}"' \
    bash "$work/completion" "$tree/tumble" 2>&1)
  status=$?
  expect 0 product
fi

what='a full disk'
if [ -c /dev/full ]; then
  for arguments in --help --version 'completion bash' 'test --help'; do
    # shellcheck disable=SC2086
    output=$(PATH="$bin:$PATH" $shell "$tree/tumble" $arguments 2>&1 >/dev/full)
    status=$?
    expect 2
  done
fi

exit $wrong
