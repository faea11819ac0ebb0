#!/bin/sh
#SBATCH --job-name=grade
#SBATCH --array=1-50
#SBATCH --cpus-per-task=4
#SBATCH --mem-per-cpu=1G
#SBATCH --time=04:00:00
#SBATCH --output=grade-%a.log
# Judges one shard of a class; SLURM starts it once for each number of --array. Submit it from the folder that
# holds tumble and class/:  sbatch slurm.sh,  or for what has failed  sbatch --array=7,12 slurm.sh
set -eu
shards=50 # the last number of --array: SLURM's own count is another one when some are started again

# The judge itself: ./tumble would look fifty times at once, in one folder, whether something has to be built.
judge=tumble/build/release/tests/judge/tumble_judge
[ -x "$judge" ] || {
  echo 'build first:  tumble/tumble prepare grade class/moodle.zip --course class/course.json' >&2
  exit 2
}
exec "$judge" grade class/moodle.zip --roster class/worksheet.csv --course class/course.json \
  --out grades --jobs "${SLURM_CPUS_PER_TASK:-1}" --shard "$SLURM_ARRAY_TASK_ID/$shards"
