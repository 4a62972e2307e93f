#!/bin/bash
#SBATCH --job-name=gt2003
#SBATCH --cpus-per-task=1
#SBATCH --requeue
# sbatch --array=1-100 slurm-array.sh JOBS FOLDER: a list of jobs without Ray. Each task of the array does its share of the list
# and appends to a file of its own; one that is started again goes on where it was. When all are done:
#   experiment merge FOLDER/results-*.jsonl --jobs JOBS --json FOLDER/experiments.json
# Any scheduler that numbers its tasks does it likewise.
set -euo pipefail
jobs=$1 folder=$2
mkdir -p "$folder"
awk -v task="$SLURM_ARRAY_TASK_ID" -v all="$SLURM_ARRAY_TASK_COUNT" 'NR % all == task % all' "$jobs" |
  experiment run - --threads "${SLURM_CPUS_PER_TASK:-1}" --out "$folder/results-$SLURM_ARRAY_TASK_ID.jsonl"
