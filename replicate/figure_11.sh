#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 11: batter is poured into a pan, cooked and flipped.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 11
