#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Fails if a file includes what its room may not: the table below, explained in CONTRIBUTING.md, "Rooms". A room may include itself.
# No room but meshing may include meshing (and tests, which are not shipped): its licence is the GPL.
set -euo pipefail
sources=$(dirname "$0")/sources.sh
table='
solver/core:
solver/boundary: solver/core
solver/effects: solver/core
solver/grid: solver/core solver/boundary
solver/scene: solver/core solver/boundary solver/effects
solver/io: solver/core solver/boundary solver/scene bake_build.h bake_commit.h
solver/engine: solver/core solver/boundary solver/effects solver/grid solver/scene solver/io
solver/run: solver/core solver/boundary solver/effects solver/grid solver/scene solver/io solver/engine
solver/program: solver/core solver/scene solver/io
solver/identity:
reference: solver
analysis: solver
meshing: solver analysis/claims
experiments: solver analysis reference
cli: solver analysis reference experiments
tests: solver analysis reference experiments meshing'
rooms=$(sed -n 's|^\([a-z]*\).*:.*|\1|p' <<<"$table" | sort -u | paste -sd '|')  # in <>, too, which find them as well

"$sources" "$1" | grep -E '\.(h|cpp|h\.in|cpp\.in)$' | (cd "$1" && xargs -r -d '\n' grep -nE '^[ \t]*#[ \t]*include[ \t]*("|<('"$rooms"')/)' /dev/null) |
  awk -F '[:"<>]' -v table="$table" '
    function room_of(path,   part) { split(path, part, "/"); return part[1] == "solver" ? part[1] "/" part[2] : part[1] }
    BEGIN { for (n = split(table, line, "\n"); n > 1; --n) { split(line[n], pair, ":"); allowed[pair[1]] = pair[1] pair[2] } }
    {
      room = room_of($1)
      known = room in allowed
      good = 0
      for (n = split(allowed[room], prefix, " "); n > 0; --n)
        if ($4 == prefix[n] || index($4, prefix[n] "/") == 1) good = $4 == prefix[n] || room_of($4) in allowed
      if (!good) { printf "%s:%s: found #include \"%s\", allowed: %s\n", $1, $2, $4, known ? allowed[room] : "nothing, for " room " is no room of the table"; ++bad }
    }
    END { print NR " includes checked"; exit NR == 0 || bad > 0 }'
