#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: papaparse 5.7.1 (npm).
# Behaviour: whether a short CSV file with semicolons and decimal commas is split at the semicolons depends on the newline at its end: with
# it, the file is split at the commas, inside the numbers, and the list of errors stays empty.
# Expected: the semicolon, which divides every line into two, as without the newline; the comma divides the lines into one and three. The
# standard of CSV, RFC 4180, makes the last newline optional, and the package promises to detect the delimiter.
# Seen: with no newline at the end, 1,5 and 2,5; with one, the three fields 1, 5;2 and 5; no error either time.
source "$(dirname "$0")/common.sh"
npm_packages papaparse@5.7.1
cat >read.cjs <<'END'
const Papa = require('papaparse');
for (const end of ['', '\n']) {
  const {data, errors} = Papa.parse('x;y\n1,5;2,5\n3,5;4,5' + end);
  console.log(data[1].join(' | '), errors.length, 'errors;');
}
END
look_at node read.cjs
conclude "1,5 | 2,5 0 errors; 1 | 5;2 | 5 0 errors;" "in Papa Parse, a newline at the end of the file decides where its lines are split"
