#!/bin/sh
# A study as a Slurm array: each task is a shard and needs nothing but files. Submit with
#
#     STUDY=samples/studies/table-2.json OUT=/shared/table-2 sbatch --array=1-16 samples/studies/slurm.sh
#
# and, when all tasks have ended,
#
#     glissade-cli merge /shared/table-2/shard-* --out /shared/table-2/all
#
# A task that was killed or ran out of its time goes on where it was when it is submitted again; SHARDS
# is the size of the first array where only some tasks are. CLI names the program where it is not on the
# PATH; QUICK=--quick tries it out.
#SBATCH --job-name=glissade-study
#SBATCH --cpus-per-task=2
#SBATCH --mem-per-cpu=4G
#SBATCH --time=12:00:00
#SBATCH --signal=B:INT@60
set -eu
: "${STUDY:?names the study file}" "${OUT:?names the folder of the shards}"
exec "${CLI:-glissade-cli}" study "$STUDY" ${QUICK:-} --jobs "${SLURM_CPUS_PER_TASK:-1}" \
  --out "$OUT/shard-$SLURM_ARRAY_TASK_ID" --shard "$SLURM_ARRAY_TASK_ID/${SHARDS:-$SLURM_ARRAY_TASK_COUNT}"
