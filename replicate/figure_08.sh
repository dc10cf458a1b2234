#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 8: yield stress and viscosity over temperature.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 8
