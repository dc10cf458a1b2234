#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: python3-zarr 2.13.6+ds-1 and python3-numcodecs 0.11.0+ds-4+b1.
# Behaviour: the filter Delta, with a type of floats, loses all numbers of a chunk that stand behind a very large one, such as the mark of
# a missing value: reading adds up the rounded differences, and the small numbers are no longer in them.
# Expected: the numbers that were written, as with integers, or a refusal of floats. The documentation of the filter warns of integers that
# do not fit a smaller type, which one may ask for, and tells nothing of floats.
# Seen: the doubles 15, 25, 1e20, 35, 45 are read as 15, 25, 1e20, 0, 10; as integers, with 1e18, all of them return.
source "$(dirname "$0")/common.sh"
debian_packages python3-zarr=2.13.6+ds-1 python3-numcodecs=0.11.0+ds-4+b1
cat >delta.py <<'END'
import numcodecs, zarr

for type, missing in ("f8", 1e20), ("i8", 10**18):
    values = zarr.array([15, 25, missing, 35, 45], dtype=type, filters=[numcodecs.Delta(dtype=type)])
    print(type, *(f"{x:g}" for x in values[:]), end="; ")
END
look_at "$python" delta.py
conclude "f8 15 25 1e+20 0 10; i8 15 25 1e+18 35 45;" "Zarr's filter Delta loses the floats that stand behind a very large one"
