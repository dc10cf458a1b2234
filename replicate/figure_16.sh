#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 16: a baked loaf is pulled apart.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 16
