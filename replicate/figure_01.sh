#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 1: breads, cookies, pancakes, fruit and more, side by side.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 1
