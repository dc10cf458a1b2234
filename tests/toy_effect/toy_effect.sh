#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# A new effect is one file and two lines: browning.h is added to a copy of the tree, compiled (fast, not optimised) and tried (main.cpp).
# A hook of it with a wrong signature does not compile, and the error names the hook.
# Usage: toy_effect.sh <source folder> <compiler>
set -euo pipefail
root=$1 compiler=$2
here=$root/tests/toy_effect
copy=$(mktemp -d)
trap 'rm -rf "$copy"' EXIT
fail() { echo "$*" >&2; exit 1; }

cp -r "$root"/{CMakeLists.txt,CMakePresets.json,bake,solver} "$copy/"
# the one file and the two lines
cp "$here/browning.h" "$copy/solver/effects/"
sed -i 's|^    Water, .*|&\n    Browning,  //|' "$copy/solver/effects/all_effects.h"
sed -i 's|^    Composition<FreeSurface, Heat>, .*|&\n    Composition<FreeSurface, Heat, Browning>,  //|' "$copy/solver/engine/model_list.h"
lines=$(diff -r "$root/solver" "$copy/solver" | grep -c '^>' || true)
((lines == 2)) || fail "the effect took $lines lines outside its own file, allowed: 2"

# Only what the toy needs: no other rooms, none of the other combinations but one that moves, as the vertices of a skin do, no optimisation.
sed -i '/^    Composition</{/Browning>,\|<Motion, Elasticity>,/!d}' "$copy/solver/engine/model_list.h"
sed -i 's|Composition<Motion, Elasticity>,  *//|Composition<Motion, Elasticity>>;|' "$copy/solver/engine/model_list.h"
sed -i 's/^set(BAKE_ROOMS .*/set(BAKE_ROOMS solver)/; s/^set(BAKE_SOLVER_FLAGS .*/set(BAKE_SOLVER_FLAGS -O0)/; s/"-O2 -DNDEBUG"/"-O0"/' \
  "$copy/CMakeLists.txt"
cat >>"$copy/CMakeLists.txt" <<END
add_executable(toy "$here/main.cpp")
target_link_libraries(toy PRIVATE bake_run)
END
cmake -S "$copy" -B "$copy/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" -DBAKE_TESTS=OFF -DBAKE_FIGURES=OFF \
  >"$copy/log" 2>&1 || fail "configuring failed: $(tail -n 20 "$copy/log")"
ninja -C "$copy/build" toy >"$copy/log" 2>&1 || fail "building failed: $(grep -m 5 error: "$copy/log")"
"$copy/build/toy" "$copy"

# gather with one argument too few
sed -i 's/gather(auto& p, const auto&, const auto& k, const auto& step, auto& books)/gather(auto\& p, const auto\& k, const auto\& step, auto\& books)/' \
  "$copy/solver/effects/browning.h"
if ninja -C "$copy/build" toy >"$copy/log" 2>&1; then fail "a hook with a wrong signature compiled"; fi
grep -q "error:.*hook 'gather'" "$copy/log" || fail "the error does not name the hook: $(grep -m 3 error: "$copy/log")"
echo "a hook with a wrong signature does not compile"
