#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 13: apple slices of three thicknesses dry, shrink and buckle.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 13
