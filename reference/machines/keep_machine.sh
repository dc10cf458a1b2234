#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Keeps what `./bake bench` has measured as reference/machines/<name>.json: without the machine's name and the program's place, and
# with single repetitions only. Usage: keep_machine.sh <file of ./bake bench> <name>
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
(($# == 2)) || { echo "usage: keep_machine.sh <file of ./bake bench> <name>" >&2; exit 2; }
python3 - "$1" "$root/machines/$2.json" <<'END'
import json, sys

with open(sys.argv[1]) as file:
    bench = json.load(file, parse_constant=lambda word: None)
if bench["context"].get("program.dirty") != "false":
    sys.exit("keep_machine.sh: the program was built from sources with changes, allowed: a commit")
for key in ("host_name", "executable"):
    bench["context"].pop(key, None)
bench["benchmarks"] = [run for run in bench["benchmarks"] if run["run_type"] == "iteration"]
with open(sys.argv[2], "w") as file:
    json.dump(bench, file, indent=1)
    file.write("\n")
print(sys.argv[2], "is written")
END
