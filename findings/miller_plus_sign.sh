#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: miller 6.6.0-2+b3.
# Behaviour: a number that is written with a plus sign, or a NaN, is a text to Miller. The statistics count it, leave it out of sum and
# mean in silence, and take it for the greatest.
# Expected: +5 is 5, as -5 is -5, and a NaN makes a sum NaN; or an error, since the help of stats1 says that only count and mode allow text
# and that the rest require numbers. The format %+g writes such numbers.
# Seen: the mean of 1 and 5 is 3, that of 1 and +5 is 1, that of 1 and NaN too, with a count of 2 each time.
source "$(dirname "$0")/common.sh"
debian_packages miller=6.6.0-2+b3
means() {
  local value
  for value in 5 +5 NaN; do
    printf 'shift\n1\n%s\n' "$value" | mlr --icsv --ocsv --headerless-csv-output stats1 -a count,sum,mean,max -f shift
  done
}
look_at means
conclude "2,6,3,5 2,1,1,+5 2,1,1,NaN" "Miller leaves numbers with a plus sign, and NaN, out of sums and means but counts them"
