#!/bin/sh
#SBATCH --job-name=grade
#SBATCH --array=1-50
#SBATCH --cpus-per-task=4
#SBATCH --mem-per-cpu=1G
#SBATCH --time=04:00:00
#SBATCH --output=grade-%a.log
# Judges one shard of a class. SLURM starts this once for each number of --array.
set -eu
shards=50 # as --array says; SLURM's own count is another one when some are started again

# The judge itself: ./tumble would look fifty times at once whether something has to be built.
judge=tumble/build/release/tests/judge/tumble_judge
[ -x "$judge" ] || {
  echo 'first:  tumble/tumble prepare grade class/moodle.zip --course class/course.json' >&2
  exit 2
}
exec "$judge" grade class/moodle.zip --roster class/worksheet.csv --course class/course.json \
  --out grades --jobs "${SLURM_CPUS_PER_TASK:-1}" --shard "$SLURM_ARRAY_TASK_ID/$shards"
