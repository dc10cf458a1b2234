#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The Snakefile makes every figure of a small paper, run by run, and the study of accuracy, case by case:
# snakemake_test.sh <source folder> <bake program> on this machine, skipped (77) where snakemake is not installed; with a third word,
# slurm, through the Slurm cluster that the machine belongs to (some minutes: snakemake asks for the state of a job every half minute; run
# it when the Snakefile changes, where there is a Slurm).
set -euo pipefail
command -v snakemake >/dev/null || exit 77

source_folder=$1
bake=$2
[[ ${3:-} == slurm ]] && way=(--slurm --jobs 2 --default-resources runtime=10) || way=(--cores 2)
paper=$(mktemp -d)  # with slurm, set TMPDIR to a folder that all nodes see
trap 'rm -rf "$paper"' EXIT
cd "$paper"
mkdir -p paper experiments/teaching
cp "$source_folder/Snakefile" .
cp "$source_folder/experiments/teaching/falling_ball.toml" experiments/teaching/
cat >paper/items.toml <<'END'
[[item]]
number = "figure 1"
name = "ball"
shows = "a ball falls"
experiment = "teaching"
status = "done"
END
cat >experiments/teaching/figure.toml <<'END'
title = "A ball"
shows = "it falls"
[[run]]
name = "light"
scene = "falling_ball"
set = ["run.end_s=0.1", "material.0.density_kg_per_m3=500"]
[[run]]
name = "heavy"
scene = "falling_ball"
set = "run.end_s=0.1"
[[claim]]
metric = "retired_particles"
of = ["light", "heavy"]
at_most = 0
kind = "analytic"
why = "it stays in the domain"
END

fail() { echo "FAILED: $*"; tail -n 30 log; exit 1; }
make_all() { HOME=$paper snakemake "$@" "${way[@]}" --config "bake=$bake" threads=1 effort=quick cases=elastic_bar,cooling_sphere >log 2>&1; }

make_all || fail "snakemake failed"
[[ $(grep -c '^rule run:' log) == 2 ]] || fail "not a job for each run"
grep -q '"holds": true' results/items/ball-draft/claims.json || fail "no claims were checked"
mv results by_snakemake
"$bake" figure ball --quiet >/dev/null
for run in light heavy; do
  cmp "results/$run-draft/frames/0001.hdf" "by_snakemake/$run-draft/frames/0001.hdf" || fail "other results than bake figure"
done
sed -i 's/at_most = 0/at_most = -1/' experiments/teaching/figure.toml
if make_all; then fail "a missed claim was a success"; fi
[[ ! -e results/made ]] || fail "markers were left behind: a second call would do nothing"

make_all accuracy || fail "the study of accuracy failed"
[[ $(grep -c '^rule accuracy_case:' log) == 2 ]] || fail "not a job for each case"
[[ $(grep -c '^## ' results/studies/accuracy/accuracy.md) == 2 ]] || fail "no page of both cases"
"$bake" study accuracy --quick --case elastic_bar --case cooling_sphere 2>/dev/null | grep -q ' 0 measured now' || fail "not all was measured"
