#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 14: trial states and where the return map takes them.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 14
