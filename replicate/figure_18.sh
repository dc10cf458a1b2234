#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Figure 18: a raw and a roasted marshmallow are pressed and released.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure 18
