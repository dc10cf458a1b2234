#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 2: a muffin with chocolate chips rises to a dome, is torn open, and its chips have melted.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 2
