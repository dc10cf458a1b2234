#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 9: grapes dry to raisins, and their skin wrinkles.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 9
