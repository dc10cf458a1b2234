#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: numeric 1.2.6.
# Behaviour: toCSV writes as many columns as the table has rows: the others are lost.
# Expected: all of them. parseCSV, the function beside it, reads any table.
# Seen: of two rows of four numbers two numbers of each row are written; of one row of four the first one.
source "$(dirname "$0")/common.sh"
npm_packages numeric@1.2.6
cat >csv.js <<'END'
const numeric = require("numeric");
const text = "1, 2, 3, 4\n5, 6, 7, 8";
console.log("read", JSON.stringify(numeric.parseCSV(text)));
console.log("written", JSON.stringify(numeric.toCSV(numeric.parseCSV(text)).trim()));
console.log("one row", JSON.stringify(numeric.toCSV([[1, 2, 3, 4]]).trim()));
END
look_at node csv.js
conclude 'read [[1,2,3,4],[5,6,7,8]] written "1, 2\n5, 6" one row "1"' \
  "numeric writes as many columns of a table as it has rows"
