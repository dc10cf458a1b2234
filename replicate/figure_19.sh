#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 19: the poured batter beside that of Stomakhin et al. 2014.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 19
