#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# An effect that is off costs nothing, by the clock: the benchmarks are built once more from sources that never had it, and both
# programs time the same combination of the other effects in turn. (That the machine code is the same is a test:
# tests/unit/engine/off_is_free.sh.) Takes some minutes on a machine that does nothing else.
#
#   tests/bench/never_had.sh [effect [combination [rounds]]]      default: leavening plastic+heat+water 10
#
# Exit codes: 0 the times agree, 1 they do not: one program was the faster in so many rounds that chance would do it once in a hundred
# times, 2 wrong use, 3 building failed.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)
effect=${1:-leavening} combination=${2:-plastic+heat+water} rounds=${3:-10}
die() { echo "never_had: ${*:2}" >&2; exit "$1"; }
[[ -f $root/solver/effects/$effect.h ]] || die 2 "there is no effect $effect"
[[ +$combination+ != *+$effect+* ]] || die 2 "$combination has $effect"
((rounds >= 2)) || die 2 "rounds: found $rounds, allowed: at least 2"

without=$(mktemp -d)
trap 'rm -rf "$without"' EXIT
git -C "$root" ls-files -z | tar -C "$root" --null -T - -c | tar -C "$without" -x

source "$root/tests/unit/engine/take_out.sh"
take_out "$effect" "$without" || die 2 "nothing could be taken out of $effect.h"
type=$(sed -E 's/(^|_)(.)/\U\2/g' <<<"$effect")
sed -i -E "/^ +Composition</ s/(, $type\b|\b$type, )//" "$without/solver/engine/model_list.h"

for tree in "$root" "$without"; do (cd "$tree" && ./bake bench --benchmark_list_tests >/dev/null) || die 3 "building failed"; done

# The time of a particle-step [ns of a core].
time_of() { # <folder>
  "$1/build/release/bake_bench" --benchmark_filter="^Step/${combination//+/\\+}/single/500K/threads:1" \
    --benchmark_out="$without/times.json" >/dev/null 2>&1
  sed -n 's/^ *"ns\*core": \([0-9.e+-]*\),*$/\1/p' "$without/times.json"
}
printf 'ns a particle-step of %s, single precision, 500K particles, one thread\nround    as it is   never had %s    ratio\n' "$combination" "$effect"
for ((round = 1; round <= rounds; ++round)); do
  # who begins changes from round to round
  if ((round % 2)); then with=$(time_of "$root") never=$(time_of "$without"); else never=$(time_of "$without") with=$(time_of "$root"); fi
  [[ -n $with && -n $never ]] || die 2 "no benchmark times $combination"
  echo "$round $with $never"
done | awk -v effect="$effect" '
  { ratio[NR] = $2 / $3; slower += ratio[NR] > 1; printf "%5d %10.2f %10.2f %*.3f\n", $1, $2, $3, 10 + length(effect) - 1, ratio[NR] }
  END {
    if (NR == 0) exit 2
    n = asort_numbers(ratio)
    few = slower < n - slower ? slower : n - slower  # sign test, both sides
    for (k = 0; k <= few; ++k) chance += 2 * choose(n, k) / 2 ^ n
    if (chance > 1) chance = 1
    printf "median ratio %.3f, lowest %.3f, highest %.3f; as it is slower in %d of %d rounds, by chance at least as lopsided: %.2g\n",
      (ratio[int((n + 1) / 2)] + ratio[int(n / 2) + 1]) / 2, ratio[1], ratio[n], slower, n, chance
    exit chance < 0.01
  }
  function asort_numbers(a,   i, j, t, n) {
    n = NR
    for (i = 2; i <= n; ++i) { t = a[i]; for (j = i - 1; j > 0 && a[j] > t; --j) a[j + 1] = a[j]; a[j + 1] = t }
    return n
  }
  function choose(n, k,   c, i) { c = 1; for (i = 1; i <= k; ++i) c = c * (n - k + i) / i; return c }'
