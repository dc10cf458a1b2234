#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: datamash 1.7-2.
# Behaviour: a NaN in a column makes max and min NaN if it is in the first line, and is passed over in silence anywhere else.
# Expected: the same from the same numbers in any order: NaN, which sum and mean give, or what --narm gives, the option that skips NaN. The
# manual knows no other way to skip one. A run that became NaN after its first step looks sound.
# Seen: the greatest of nan, 1, 2 is nan, of 1, nan, 2 it is 2; the sum is nan both times.
source "$(dirname "$0")/common.sh"
debian_packages datamash=1.7-2
greatest() {
  printf '%s\n' nan 1 2 | datamash min 1 max 1 sum 1
  printf '%s\n' 1 nan 2 | datamash min 1 max 1 sum 1
}
look_at greatest
conclude "nan	nan	nan 1	2	nan" "the greatest number of a column with a NaN depends on the order of the lines in datamash"
