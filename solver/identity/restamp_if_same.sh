#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Gives data kept below a folder a new identity of the solver if the machine code of two folders of object files is the same;
# else changes nothing, says what differs, exit code 1. Each file is replaced whole or not at all.
# Usage: restamp_if_same.sh <bake-same-code> <objects> <objects> <identity> <new identity> <folder>
set -euo pipefail
(($# == 6)) || { echo "usage: restamp_if_same.sh <bake-same-code> <objects> <objects> <identity> <new identity> <folder>" >&2; exit 2; }
"$1" "$2" "$3"
was="\"solver\":( ?)\"$4\""
cd "$6"

count=0
while IFS= read -r -d '' file; do
  new=$(mktemp "$file.XXXXXX")
  trap 'rm -f "$new"' EXIT
  cp -p "$file" "$new"
  sed -E "s/$was/\"solver\":\1\"$5\"/g" "$file" >"$new"
  sync "$new"
  mv "$new" "$file"
  echo "$file: $(grep -oE "\"solver\": ?\"$5\"" "$file" | wc -l) of $5"
  count=$((count + 1))
done < <(find -H paper/accuracy experiments/table01_timings/measured results -type f \( -name '*.json' -o -name '*.jsonl' \) \
  -exec grep -qE "$was" {} \; -print0 2>/dev/null)
echo "$count files have the identity $5 instead of $4"
