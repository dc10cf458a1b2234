#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 6: cylinders of dough are pulled and twisted, over yield stress and viscosity.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 6
