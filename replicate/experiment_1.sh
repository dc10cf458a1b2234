#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Experiment 1: whether a loaf cracks on top, over the Biot number: the difference of crust and core.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure crack_biot
