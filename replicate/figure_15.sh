#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 15: a loaf without slits, with one and with three expands and opens.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 15
