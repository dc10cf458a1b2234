# SPDX-License-Identifier: MIT
# Every run of every figure as a job of its own, then every figure: on this machine or handed out to a cluster, with the same results.
#
#   snakemake --cores 2                                          all figures at draft
#   snakemake --cores 2 results/made/bread-draft                 one figure
#   snakemake --cores 16 --config quality=standard
#   snakemake --cores 2 accuracy                                 bake study accuracy --full, its cases side by side
#   snakemake --slurm --jobs 8 --default-resources runtime=600 --config bake=build/release/bake threads=16
#                                                                on a Slurm cluster, from a folder that all nodes see;
#                                                                a target (`accuracy`) stands before --slurm, not after it
#
# A Slurm job asks for `threads` cores (default 8; if no node has as many it waits for ever), `memory_MB` (default 4000) and `runtime`
# minutes; slurm_account=... and slurm_partition=... stand beside runtime if the cluster wants them. A job that is cut off leaves a
# checkpoint, and the same line goes on from there. Build first, with the preset `reference` if the nodes' processors differ.
#
# The program is ./bake unless told otherwise (--config bake=build/release/bake). What is up to date is left to it: it simulates nothing twice.
#
# `accuracy` measures times: give it cores of one kind that do nothing else, for the page takes only what was measured on such a processor.
# It goes on where it stood, and writes to results/studies/accuracy (--config study_out=paper).
import shutil
import subprocess

BAKE = config.get("bake", "./bake")
QUALITY = config.get("quality", "draft")
MEMORY_MB = config.get("memory_MB", 4000)  # of a Slurm job; snakemake would ask for 1000, about what the surface of a crack takes at paper
OPTIONS = config.get("options", "")  # further ones of `bake figure`, e.g. --no-pictures

RUNS = {}  # of each figure
for line in subprocess.run([BAKE, "list", "runs"], check=True, text=True, stdout=subprocess.PIPE).stdout.splitlines():
    figure, *run = line.split()
    RUNS.setdefault(figure, []).extend(run)
FIRST = {}  # the figure that simulates a run: figures may share runs
for figure, runs in RUNS.items():
    for run in runs:
        FIRST.setdefault(run, figure)

CASES = subprocess.run([BAKE, "list", "cases"], check=True, text=True, stdout=subprocess.PIPE).stdout.split()
CASES = config["cases"].split(",") if "cases" in config else CASES  # --config cases=vortex,drying_cube
STUDY = f"{BAKE} study accuracy --{config.get('effort', 'full')} --out {config.get('study_out', 'results/studies/accuracy')}"


localrules: all


wildcard_constraints: quality="draft|standard|paper", run="[^.]+"


rule all:
    input: expand("results/made/{figure}-{quality}", figure=RUNS, quality=QUALITY)


# Markers of this call only: bake alone knows what is up to date.
onsuccess: shutil.rmtree("results/made", ignore_errors=True)
onerror: shutil.rmtree("results/made", ignore_errors=True)


rule run:
    output: touch("results/made/{figure}-{quality}.{run}")
    threads: config.get("threads", 8)
    resources: mem_mb=MEMORY_MB
    shell: "{BAKE} figure {wildcards.figure} --quality {wildcards.quality} --only-run {wildcards.run} --threads {threads}"


rule figure:
    input: lambda wildcards: [f"results/made/{FIRST[run]}-{wildcards.quality}.{run}" for run in RUNS[wildcards.figure]]
    output: touch("results/made/{figure}-{quality}")
    threads: config.get("threads", 8)
    resources: mem_mb=MEMORY_MB
    shell: "{BAKE} figure {wildcards.figure} --quality {wildcards.quality} --threads {threads} {OPTIONS}"


rule accuracy_case:
    output: touch("results/made/accuracy/{case}")
    threads: 1
    resources: mem_mb=MEMORY_MB
    shell: "{STUDY} --case {wildcards.case} --measure-only"


rule accuracy:
    input: expand("results/made/accuracy/{case}", case=CASES)
    threads: 1
    resources: mem_mb=MEMORY_MB
    params: cases=[f"--case {case}" for case in CASES]
    shell: "{STUDY} {params.cases}"
