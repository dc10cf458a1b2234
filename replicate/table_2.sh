#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Table 2: the parameters of each scene.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" table 2
