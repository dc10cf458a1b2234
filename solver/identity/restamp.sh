#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# What is kept of runs stays valid if the solver's sources have changed but its machine code has not: compares a commit's solver with
# the present one, both built with the preset `reference`, and gives the kept data the present identity.
# Usage, by ./bake restamp: CXX=<compiler> restamp.sh <bake-same-code> [<commit>]
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
root=$(cd -- "$here/../.." && pwd -P)
work=$root/build/restamp
tree=$work/tree

say() { printf 'bake: %s\n' "$*" >&2; }
die() { say "${@:2}"; exit "$1"; }

if [[ ${2:-} == --help || ${2:-} == -h ]]; then
  printf 'Let kept data of a commit count as the present solver'"'"'s, if the machine code of both is the same\nUsage: ./bake restamp <commit>\n'
  exit 0
fi
(($# == 2)) || die 2 "usage: ./bake restamp <commit>"
commit=$(git -C "$root" rev-parse --verify --quiet --end-of-options "$2^{commit}") ||
  die 2 "restamp: found $2, allowed: a commit of this repository"

# The matching C compiler: where only g++-12 is installed there is no plain cc.
if [[ -z ${CC:-} && ${CXX##*/} == g++* ]]; then export CC=${CXX%/*}/gcc${CXX##*/g++}; fi

step() { # <log> <command...>
  "${@:2}" >>"$1" 2>&1 || { tail -n 30 "$1" >&2; die 3 "building failed; the log is $1"; }
}

# Each file compiled by itself, each function in a section of its own, and, by a build type of no flags, all rooms optimised alike: so it
# does not matter what stands beside it, nor in which room.
configure() { # <tree> <build>
  mkdir -p "$2"
  : >"$2/log"
  cd "$1"
  rm -f "$2/CMakeCache.txt"  # CMake cannot change the compiler in place
  step "$2/log" cmake --preset reference -B "$2" -DCMAKE_BUILD_TYPE=Alike \
    -DCMAKE_CXX_FLAGS="-O3 -w -DNDEBUG -ffunction-sections -fdata-sections" -DBAKE_UNITY=OFF -DBAKE_TESTS=OFF -DBAKE_FIGURES=OFF
  step "$2/log" ninja -C "$2" bake_commit
}

identity() { sed -n 's/^#define BAKE_SOLVER "\([0-9a-f]*\)"$/\1/p' "$1/generated/bake_commit.h"; }

# What decides a run's numbers is the whole solver but the programs' command lines. The reader of scenes need not be equal, since each
# run is kept with the scene that was read, and compared with it; nor need provenance.cpp, which only tells the identity.
build() { # <build>
  local -a objects beside
  mapfile -t objects < <(ninja -C "$1" -t targets all |
    sed -n 's|^\(solver/CMakeFiles/.*\.cpp\.o\): .*|\1|p' | grep -Ev '\.dir/(__|cli|identity|program)/')
  mapfile -t beside < <(printf '%s\n' "${objects[@]}" | grep -E '\.dir/scene/|/io/provenance\.cpp\.o$')
  say "building ${#objects[@]} files of the solver; the log is $1/log"
  step "$1/log" ninja -C "$1" "${objects[@]}"
  rm -rf "$1/objects"
  mkdir -p "$1/objects/beside"
  cd "$1"
  cp --parents -t objects "${objects[@]}"
  (cd objects && mv -t beside "${beside[@]}")
}

mkdir -p "$work"
exec 9>"$work/lock"
flock 9
remove_tree() { rm -rf "$tree"; git -C "$root" worktree prune; }
remove_tree
trap remove_tree EXIT
git -C "$root" worktree add --quiet --detach "$tree" "$commit"
configure "$tree" "$work/then"
configure "$root" "$work/present"
then=$(identity "$work/then") now=$(identity "$work/present")
if [[ $then == "$now" ]]; then
  say "nothing to do: the solver of $2 is the present one ($now)"
  exit
fi
build "$work/then"
build "$work/present"
"$here/restamp_if_same.sh" "$1" "$work/then/objects" "$work/present/objects" "$then" "$now" "$root"
