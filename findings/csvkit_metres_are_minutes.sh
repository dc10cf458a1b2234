#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: csvkit 1.0.7-1.
# Behaviour: a column of lengths such as 5m and 10m becomes durations of five and ten minutes; csvjson and csvsort write "0:05:00" and the
# text of the file is gone.
# Expected: the text, as for 5mm. The help of the tools speaks of type inference without naming durations, and a sorted file should have
# the fields of the unsorted one. Lengths of 5m and 500mm in one column stay text.
# Seen: 5m becomes 0:05:00, 5mm stays 5mm.
source "$(dirname "$0")/common.sh"
debian_packages csvkit=1.0.7-1
lengths() {
  printf 'beam,length\na,5m\nb,10m\n' | csvsort -c beam
  printf 'beam,length\na,5mm\nb,10mm\n' | csvsort -c beam
}
look_at lengths
conclude "beam,length a,0:05:00 b,0:10:00 beam,length a,5mm b,10mm" "csvkit turns lengths such as 5m into minutes"
