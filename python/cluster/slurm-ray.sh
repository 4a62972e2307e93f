#!/bin/bash
#SBATCH --job-name=gt2003
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=1
#SBATCH --exclusive
# sbatch --nodes=10 slurm-ray.sh run JOBS --out FOLDER, or study FILE --out FOLDER: a Ray cluster of the nodes of a Slurm job, and
# the command gt2003 on it. The environment with the package has to be active, and its folder shared by the nodes.
set -euo pipefail
port=6379
nodes=$(scontrol show hostnames "$SLURM_JOB_NODELIST")
head=$(head -1 <<<"$nodes")
# Nobody else on the nodes' network may send jobs.
export RAY_AUTH_MODE=token RAY_AUTH_TOKEN_PATH=$PWD/.ray-token-$SLURM_JOB_ID RAY_USAGE_STATS_ENABLED=0
(umask 077 && od -An -tx1 -N32 /dev/urandom | tr -d ' \n' >"$RAY_AUTH_TOKEN_PATH")
trap 'rm -f "$RAY_AUTH_TOKEN_PATH"; kill $(jobs -p) 2>/dev/null || true' EXIT

srun --nodes=1 --ntasks=1 --nodelist="$head" ray start --head --port $port --block &
until ray status --address "$head:$port" >/dev/null 2>&1; do sleep 1; done
for node in $(tail -n +2 <<<"$nodes"); do
  srun --nodes=1 --ntasks=1 --nodelist="$node" ray start --address "$head:$port" --block &
done
srun --overlap --nodes=1 --ntasks=1 --nodelist="$head" gt2003 "$@" --address "$head:$port"
