#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fails if clang-format would change a C++ source. Versions format differently, so only version 14 may judge.
set -euo pipefail
sources=$(dirname "$0")/sources.sh
for tool in clang-format-14 clang-format; do
  if [[ $("$tool" --version 2>/dev/null) == *"version 14."* ]]; then
    "$sources" "$1" | grep -E '\.(h|cpp)$' | (cd "$1" && xargs -r -d '\n' "$tool" --dry-run -Werror)
    exit
  fi
done
echo "clang-format 14 is not installed: skipped"
exit 77
