#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 7: the yield surface in the plane of pressure and shear, for several porosities.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 7
