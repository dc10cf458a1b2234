#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Tests what a build notes of its sources: the build's own command for that is run on a small tree which has the folders that the
# build compiles. Usage: provenance_test.sh <source folder> <build folder>
set -euo pipefail
command -v git >/dev/null || { echo "git is not installed: skipped"; exit 77; }
source_folder=$1 build=$2
source "$(dirname -- "${BASH_SOURCE[0]}")/checks.sh"
shown=(state solver)
tree=$sandbox/tree

note() { # writes the header and sets state and solver
  eval "${command//SOURCES=$source_folder /SOURCES=$tree }"
  state=$(sed -n 's/#define BAKE_SOURCES "\(.*\)"/\1/p' "$sandbox/header.h")
  solver=$(sed -n 's/#define BAKE_SOLVER "\(.*\)"/\1/p' "$sandbox/header.h")
}
in_tree() { git -C "$tree" -c user.name=test -c user.email=test@localhost "$@"; }

command=$(ninja -C "$build" -t commands bake_commit | grep -F write_commit.cmake)
command=${command//$build\/generated\/bake_commit.h/$sandbox/header.h}
# Folders of everything that is compiled into the programs, by itself or, within a file of CMake's, with others.
mapfile -t compiled < <(sed -n 's/^ *"file": "\(.*\)".*/\1/p' "$build/compile_commands.json")
mapfile -t rooms < <({ printf '%s\n' "${compiled[@]}"; cat "${compiled[@]}" 2>/dev/null; } |
  sed -nE "s|^(#include \")?$source_folder/([^/\"]+)/.*|\2|p" | sort -u | grep -vxE 'tests|build.*')
mkdir -p "$tree/docs" "$tree/tests" "$tree/paper"
for room in "${rooms[@]}"; do
  mkdir -p "$tree/$room"
  echo "int ${room%%/*};" >"$tree/$room/some.cpp"
done
cp "$source_folder/.gitignore" "$source_folder/CMakeLists.txt" "$source_folder/CMakePresets.json" "$source_folder/bake" "$tree"

note
expect "sources without git are of unknown state" [ "$state" == unknown ]
expect "sources without git have an identity" [ "${#solver}" == 16 ]
without_git=$solver
in_tree init --quiet
in_tree add .
in_tree commit --quiet --message all
note
expect "a new clone is clean" [ "$state" == clean ]
expect "git does not matter to the identity" [ "$solver" == "$without_git" ]
touch -d yesterday "$sandbox/header.h"
before=$(stat -c %y "$sandbox/header.h")
note
expect "the header stays as it is if nothing has changed" [ "$(stat -c %y "$sandbox/header.h")" == "$before" ]

mkdir -p "$tree/results"
for file in docs/page.md README.md "${rooms[0]}/README.md" results/run.json paper/page.json tests/new_test.cpp; do
  echo words >"$tree/$file"
  note
  expect "$file does not make it dirty" [ "$state" == clean ]
  rm "$tree/$file"
done
expect "several folders are compiled" [ "${#rooms[@]}" -gt 3 ]
for file in "${rooms[@]/%//new.cpp}" CMakeLists.txt CMakePresets.json bake; do
  echo "int added;" >>"$tree/$file"
  note
  expect "$file makes it dirty" [ "$state" == dirty ]
  if [[ $file == solver/* ]]; then
    expect "new sources are another solver" [ "$solver" != "$without_git" ]
  else
    expect "$file is no part of the solver" [ "$solver" == "$without_git" ]
  fi
  in_tree stash --quiet --include-untracked
done
echo "// a comment" >>"$tree/solver/some.cpp"
mkdir "$tree/solver/room"
mv "$tree/solver/some.cpp" "$tree/solver/room/other.cpp"
note
expect "a comment and another place make it dirty" [ "$state" == dirty ]
expect "a comment and another place leave the solver the same" [ "$solver" == "$without_git" ]

finish
