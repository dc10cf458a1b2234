#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 12: the rate of CO2 production over temperature.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 12
