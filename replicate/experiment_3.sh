#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Experiment 3: a small loaf of real constants, with vapour in its pores and without, beside measured temperatures, water and shape.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure validation_bread
