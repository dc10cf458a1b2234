#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: numeric 1.2.6.
# Behaviour: svd gives some matrices of rank one the singular values 0 and NaN, without a message.
# Expected: 5 and 0 for the rows 1 2 and 2 4: of a matrix of rank one the singular value is the root of the sum of the squares. The
# decomposition exists for every matrix, and to find the rank is what it is used for.
# Seen: 0 and NaN for the rows 1 2 and 2 4; the same columns in the other order give 5 and 0. For equal columns of three ones NaN too.
source "$(dirname "$0")/common.sh"
npm_packages numeric@1.2.6
cat >svd.js <<'END'
const numeric = require("numeric");
for (const rows of [[[1, 2], [2, 4]], [[2, 1], [4, 2]], [[1, 1], [1, 1], [1, 1]]]) {
  const values = numeric.svd(rows).S.map((value) => value.toFixed(3));
  console.log(`${JSON.stringify(rows)}: ${values.join(" and ")} for ${Math.hypot(...rows.flat()).toFixed(3)};`);
}
END
look_at node svd.js
conclude '[[1,2],[2,4]]: 0.000 and NaN for 5.000; [[2,1],[4,2]]: 5.000 and 0.000 for 5.000; [[1,1],[1,1],[1,1]]: 0.000 and NaN for 2.449;' \
  "the singular values that numeric gives a matrix of rank one can be 0 and NaN"
