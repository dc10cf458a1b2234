#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Experiment 4: biscuits of real size and time, of two flours and in three ovens, beside measured spread and what sources say of it.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure validation_biscuits
