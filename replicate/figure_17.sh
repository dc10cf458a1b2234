#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 17: cookies at three temperatures beside those of Stomakhin et al. 2014.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 17
