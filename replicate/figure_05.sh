#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 5: a marshmallow is roasted and pressed between two crackers.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 5
