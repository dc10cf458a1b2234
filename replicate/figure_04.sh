#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 4: a cake that is set outside and flows out of its centre when it is cut.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 4
