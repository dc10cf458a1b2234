#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# An effect that a scene does not list costs nothing: some combinations of effects are compiled once more from sources in which the
# files of the effects left out say what a scene may ask of them and what they are called, but can do nothing. The machine code must
# be the same, byte for byte; hence speed and results are those of a program that never had these effects.
# Usage: off_is_free.sh <source folder> <build folder>
set -euo pipefail

root=$1 build=$2
source "$root/tests/unit/engine/take_out.sh"
sandbox=$(mktemp -d)
trap 'rm -rf "$sandbox"' EXIT
failures=0

# The command that compiles a composition on its own: that of another file of the engine, from the database that CMake writes.
command_of() { # <file name of the source>
  sed -n "s|^ *\"command\": \"\(.* -c \).*/solver/engine/surface.cpp\",\$|\1$build/solver/generated/$1|p" "$build/compile_commands.json" |
    sed 's/\\"/"/g'
}

sources_without() { # <effect>...
  local effect
  rm -rf "$sandbox/without"
  mkdir -p "$sandbox/without"
  cp -r "$root/solver" "$sandbox/without/"
  for effect in "$@"; do
    take_out "$effect" "$sandbox/without" || { echo "nothing could be taken out of $effect.h" >&2; exit 2; }
  done
}

# Compiles a composition from the sources of a folder.
compile() { # <composition> <source folder> <object>
  local command
  command=$(command_of "model_$1_float.cpp" | sed -E "s| -o [^ ]+ | -o $3 |; s|-I$root |-I$2 |")
  [[ -n $command ]] || { echo "no command for composition $1" >&2; exit 2; }
  (cd "$build" && eval "$command")
}

expect_same() { # <composition> <effects left out>...
  sources_without "${@:2}"
  if ! compile "$1" "$root" "$sandbox/with.o" || ! compile "$1" "$sandbox/without" "$sandbox/without.o" ||
    ! cmp "$sandbox/with.o" "$sandbox/without.o"; then
    echo "composition $1 is not the same without ${*:2}" >&2
    failures=$((failures + 1))
  fi
}

# Numbers as in solver/engine/model_list.h.
expect_same 3 heat water moving_water plasticity leavening free_surface flip_memory  # motion, elasticity
expect_same 10 leavening flip_memory                                    # motion, heat, water, elasticity, plasticity

# The test itself: an effect that is listed cannot be taken away.
sources_without plasticity
if compile 7 "$sandbox/without" "$sandbox/broken.o" 2>/dev/null; then
  echo "plasticity was taken away from a composition that lists it, and nobody noticed" >&2
  failures=$((failures + 1))
fi
exit $((failures > 0))
