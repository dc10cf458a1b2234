#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Table 1: seconds per frame, machine, elements and particles of each simulation.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" table 1
