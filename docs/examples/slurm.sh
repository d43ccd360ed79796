#!/bin/bash
# Marks in 8 shares. Submit it with `sbatch docs/examples/slurm.sh` in the folder of fk-lab, and merge afterwards:
#   cargo harness merge share-* --out marks
#SBATCH --job-name=fk-lab
#SBATCH --array=1-8
#SBATCH --cpus-per-task=2
#SBATCH --mem=8G
#SBATCH --time=00:30:00
set -euo pipefail

# The same secret number for all shares: put one of your own here.
SEED=${SEED:?"set SEED to a secret number, the same for all shares"}

# Building once beforehand (`cargo doctor`) keeps the shares from waiting for each other.
resume=()
[ -e "share-$SLURM_ARRAY_TASK_ID/journal.jsonl" ] && resume=(--resume)
cargo grade submissions --out "share-$SLURM_ARRAY_TASK_ID" --seed "$SEED" \
  --shard "$SLURM_ARRAY_TASK_ID/$SLURM_ARRAY_TASK_COUNT" --jobs "$SLURM_CPUS_PER_TASK" "${resume[@]}"
