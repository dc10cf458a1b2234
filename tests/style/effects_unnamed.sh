#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fails if a file of the solver or the command line names an effect: what an effect knows stands in its own header. Only the list of
# combinations that are compiled may (solver/engine/model_list.h), and solver/effects itself, where the scene reader's list is.
set -euo pipefail
cd "$1"
names=$(sed -n 's/^struct \([A-Z][A-Za-z]*\) : Effect {.*/\1/p' solver/effects/*.h | grep -vx Common)
(($(wc -w <<<"$names") > 5)) || { echo "no effects were found in solver/effects" >&2; exit 1; }
words=$(sed -n 's/^  static constexpr const char\* name = "\(.*\)";/\1/p' solver/effects/*.h | grep -vx common)
headers=$(grep -l '^struct [A-Z][A-Za-z]* : Effect {' solver/effects/*.h | grep -v common | paste -sd '|')
pattern="[\"<]($headers)[\">]|\\b($(paste -sd '|' <<<"$names"))\\b|lists\\(\"($(paste -sd '|' <<<"$words"))\"\\)"
files=$("$(dirname "$0")/sources.sh" . | grep -E '^(solver|cli)/.*\.(h|cpp|in)$' | grep -vE '^solver/effects/|^solver/engine/model_list\.h$')
failures=0
for file in $files; do
  if sed 's|//.*||' "$file" | grep -nE "$pattern" | sed "s|^|$file:|" | grep .; then failures=$((failures + 1)); fi
done
((failures == 0)) || { echo "these lines name an effect" >&2; exit 1; }
