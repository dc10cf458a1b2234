#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Prints the tracked files below a folder; where there is no git, all files but results and builds.
set -euo pipefail
cd "$1"
git ls-files 2>/dev/null || find . -type f -not -path './.git/*' -not -path './build*/*' -not -path './results/*' | sed 's|^\./||'
