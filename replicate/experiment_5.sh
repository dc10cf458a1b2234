#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Experiment 5: the cookie of a model that melts and sets, over all that this model leaves free.
exec "$(dirname -- "${BASH_SOURCE[0]}")/../bake" figure melting_scan
