#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Installs every package that figures need and builds the programs. As a sign that they work it makes table 2, which needs no simulation.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" table 2
