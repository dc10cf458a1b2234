#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Experiment 2: apple slices and grapes of real constants beside measured drying curves.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure validation_drying
