#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Runs clang-tidy over the sources (all .cpp files of the rooms, or those named), each compiled alone. Not among the tests: it takes
# a quarter of an hour. Exit code 1 if it finds anything.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
cd "$root"
commands=build/tidy
mkdir -p build
cmake -S . -B "$commands" -G Ninja -DBAKE_UNITY=OFF -DBAKE_BENCHMARKS=ON >"$commands.log" || { cat "$commands.log" >&2; exit 2; }
ninja -C "$commands" bake_commit >>"$commands.log"  # makes a header
# clang knows not all of gcc's warnings
sed -i 's/-Wno-maybe-uninitialized//' "$commands/compile_commands.json"

files=("$@")
if ((${#files[@]} == 0)); then mapfile -t files < <(git ls-files -- 'solver/*.cpp' 'analysis/claims/*.cpp' 'analysis/machines/*.cpp' 'experiments/*.cpp' 'reference/*.cpp' 'cli/*.cpp'); fi
printf '%s\n' "${files[@]}" |
  xargs -P "${JOBS:-2}" -n 1 clang-tidy -p "$commands" --quiet --warnings-as-errors='*' 2> >(grep -vE '^[0-9]+ warnings? (generated|treated)' >&2 || true)
