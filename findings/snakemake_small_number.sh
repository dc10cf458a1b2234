#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: snakemake 7.21.0-1, with python3-yaml 6.0-3+b2.
# Behaviour: 1e-5 in the configuration file is a text, and on the command line (--config) a number. 1.0e-5 is a number in both.
# Expected: the same type from both, as --config is there to override the file; and a number, as in JSON, in Python and in YAML 1.2. The
# reader of the file follows YAML 1.1, where a number needs a point. In Python "2 * dt" then repeats the text without an error.
# Seen: file: str 1e-51e-5; command line: float 2e-05.
source "$(dirname "$0")/common.sh"
debian_packages snakemake=7.21.0-1 python3-yaml=6.0-3+b2
echo 'dt: 1e-5' >config.yaml
cat >Snakefile <<'END'
import sys
configfile: "config.yaml"
print("dt", type(config["dt"]).__name__, 2 * config["dt"], file=sys.stderr)
rule all:
    input: []
END
both() {
  HOME=$folder "$python" -m snakemake --dry-run --cores 1 2>&1 | grep '^dt'
  HOME=$folder "$python" -m snakemake --dry-run --cores 1 --config dt=1e-5 2>&1 | grep '^dt'
}
look_at both
conclude "dt str 1e-51e-5 dt float 2e-05" "1e-5 is a text in Snakemake's configuration file and a number on its command line"
