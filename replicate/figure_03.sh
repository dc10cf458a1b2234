#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 3: cookies of three leavener levels and three oven temperatures.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 3
