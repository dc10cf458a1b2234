#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 10: the saturation inside a grape as it dries.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 10
