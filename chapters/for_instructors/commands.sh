#!/bin/sh
# What the page shows: its commands, run on a class of four, `--only grade` and so on. The build puts
# the judge's place in.
set -eu
judge='@TUMBLE_JUDGE@'
root='@PROJECT_SOURCE_DIR@'
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# What depends on the machine is left out: walls that it lacks, times, how far a slow one is after
# ten seconds. The page's column is narrow.
tumble() {
  "$judge" "$@" 2>&1 | grep -v -e 'the sandbox lacks' -e ' left$' | sed 's/  ([0-9.]* s)$//; s/^tumble: [0-9]* s; /tumble: /' |
    fold -s -w 96
}

# solve STUDENT UNIT...: hands in solutions of chapter 1.
solve() {
  folder=submissions/$1/exercises/01_particles
  mkdir -p "$folder"
  shift
  for unit in "$@"; do cp "$root/solutions/01_particles/$unit.cpp" "$folder"; done
}

# A class: Ann has solved it, Ben has a mistake, Cleo's file has a typing error, Dan sends a link.
class() {
  cat >course.json <<'JSON'
{"title": "Homework 1", "units": ["1.1", "1.3", "1.5"], "weights": {"1.5": 2}, "seed": 8231}
JSON
  solve ann flatten euler_step rk4_step
  solve ben flatten rk4_step
  sed 's/y + h \*/y - h */' "$root/solutions/01_particles/euler_step.cpp" \
    >submissions/ben/exercises/01_particles/euler_step.cpp
  solve cleo flatten
  sed 's/return/retrun/' "$root/solutions/01_particles/rk4_step.cpp" \
    >submissions/cleo/exercises/01_particles/rk4_step.cpp
  ln -s /etc/passwd flatten.cpp
  cmake -E tar cf submissions/dan.tar flatten.cpp
}

case $2 in
  handout)
    tumble handout --chapters 1-4 homework
    if command -v git >/dev/null; then
      cd homework && git init -q && git add -A
      git -c user.name=Ann -c user.email=ann@example.org commit -q -m 'Homework 1'
    fi ;;
  grade)
    class
    tumble grade submissions --course course.json ;;
  again)
    class
    tumble grade submissions --course course.json >/dev/null
    solve cleo rk4_step
    tumble grade submissions --course course.json ;;
  csv)
    class
    tumble grade submissions --course course.json >/dev/null
    cat grades/grades.csv ;;
  settings)
    class
    cat course.json ;;
  reads)
    class
    tumble grade submissions --course course.json >/dev/null
    seed=$(sed -n '0,/"seed"/s/.*"seed": \([0-9]*\).*/\1/p' grades/students/ben.json)
    tumble check 1.3.1 --from submissions/ben/exercises --seed "$seed" ;;
  report)
    class
    tumble grade submissions --course course.json >/dev/null
    tumble report ;;
  mistake)
    echo '{"units": ["1.1", "1.3", "1.5"], "weight": {"1.5": 2}}' >course.json
    mkdir -p submissions/ann
    tumble grade submissions --course course.json || true ;;
  export)
    class
    for platform in gradescope prairielearn classroom50 github-actions; do
      tumble export $platform $platform --course course.json
      (cd "$platform" && printf '  %s\n' *)
    done ;;
esac
