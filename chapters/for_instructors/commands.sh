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
plain() {
  grep -v -e 'the sandbox lacks' -e ' left$' | sed 's/  ([0-9.]* s)$//; s/^tumble: [0-9]* s; /tumble: /' |
    fold -s -w 96
}
tumble() { "$judge" "$@" 2>&1 | plain; }

# solve FOLDER UNIT...: puts solutions of chapter 1 there.
solve() {
  folder=$1/exercises/01_particles
  mkdir -p "$folder"
  shift
  for unit in "$@"; do cp "$root/solutions/01_particles/$unit.cpp" "$folder"; done
}

# pack FOLDER: the folder becomes what Moodle lets download.
pack() {
  (cd "$1" && cmake -E tar cf ../moodle.zip --format=zip -- *)
}

# A class: Ann has solved it, Ben has a mistake and an archive, Cleo's file has a typing error, Dan's archive
# has a link in it, Eve has handed in nothing.
class() {
  cat >course.json <<'JSON'
{"title": "Homework 1", "units": ["1.1", "1.3", "1.5"], "weights": {"1.5": 2}, "seed": 8231}
JSON
  cat >worksheet.csv <<'CSV'
Identifier,Full name,Email address,Status,Grade,Maximum Grade,Last modified (submission),Last modified (grade),Feedback comments
Participant 4711001,Ann Meyer,ann@example.edu,Submitted,,4.00,"Monday, 30 November 2026, 6:12 PM",-,
Participant 4711002,Ben Kim,ben@example.edu,Submitted,,4.00,"Tuesday, 1 December 2026, 9:40 PM",-,
Participant 4711003,Cleo Roth,cleo@example.edu,Submitted,,4.00,"Tuesday, 1 December 2026, 11:58 PM",-,
Participant 4711004,Dan Li,dan@example.edu,Submitted,,4.00,"Wednesday, 2 December 2026, 8:02 AM",-,
Participant 4711005,Eve Adams,eve@example.edu,No submission,,4.00,-,-,
CSV
  end=_assignsubmission_file_
  solve "moodle/Ann Meyer_4711001$end" flatten euler_step rk4_step
  solve ben flatten rk4_step
  sed 's/y + h \*/y - h */' "$root/solutions/01_particles/euler_step.cpp" \
    >ben/exercises/01_particles/euler_step.cpp
  mkdir -p "moodle/Ben Kim_4711002$end" "moodle/Dan Li_4711004$end"
  (cd ben && cmake -E tar cf "../moodle/Ben Kim_4711002$end/homework1.zip" --format=zip exercises)
  solve "moodle/Cleo Roth_4711003$end" flatten
  sed 's/return/retrun/' "$root/solutions/01_particles/rk4_step.cpp" \
    >"moodle/Cleo Roth_4711003$end/exercises/01_particles/rk4_step.cpp"
  ln -s /etc/passwd flatten.cpp
  cmake -E tar cf "moodle/Dan Li_4711004$end/homework1.tar" flatten.cpp
  pack moodle
}

grade() { tumble grade moodle.zip --roster worksheet.csv --course course.json; }

case $2 in
  handout)
    tumble handout --chapters 1-4 homework
    if command -v git >/dev/null; then
      cd homework && git init -q && git add -A
      git -c user.name=Ann -c user.email=ann@example.org commit -q -m 'Homework 1'
    fi ;;
  grade)
    class
    grade ;;
  again)
    class
    grade >/dev/null
    solve "moodle/Cleo Roth_4711003_assignsubmission_file_" rk4_step
    pack moodle
    grade ;;
  csv)
    class
    grade >/dev/null
    sed 's/,[^,]*,[^,]*,[^,]*$//' grades/grades.csv ;; # without name, number, address: the column is narrow
  settings)
    class
    cat course.json ;;
  rules)
    class
    cat >course.json <<'JSON'
{"title": "Homework 1", "units": ["1.1", "1.3", "1.5"], "weights": {"1.5": 2}, "seed": 8231,
 "due": "2026-12-01T23:59:00+01:00",
 "late": {"grace": 15, "per_day": 10, "days": 3},
 "extensions": {"Ben Kim": "2026-12-08T23:59:00+01:00"},
 "overrides": {"Cleo Roth": {"1.5": 2, "reason": "a typing error, corrected in the tutorial"}}}
JSON
    grade >/dev/null # what the page shows is valid
    cat course.json ;;
  reads)
    class
    grade >/dev/null
    tumble check 1.3 --student "grades/students/Ben Kim_4711002.json" ;;
  report)
    class
    grade >/dev/null
    tumble report ;;
  slurm)
    cat "$root/chapters/for_instructors/slurm.sh" ;;
  shards) # what SLURM would start, one after the other, on three machines
    class
    mkdir -p class tumble/build/release/tests/judge
    mv moodle.zip worksheet.csv course.json class
    ln -s "$judge" tumble/build/release/tests/judge/tumble_judge
    sed 's/^shards=50/shards=3/' "$root/chapters/for_instructors/slurm.sh" >slurm.sh
    for SLURM_ARRAY_TASK_ID in 1 2 3; do
      export SLURM_ARRAY_TASK_ID
      sh slurm.sh 2>&1
    done | plain
    tumble grade --merge grades ;;
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
