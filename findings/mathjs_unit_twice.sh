#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: mathjs 15.2.0 (npm).
# Behaviour: one text of a quantity, such as "4180 J/kg K", is another quantity for the function unit than for evaluate. To unit, K belongs
# to the numerator; to evaluate, it belongs to the denominator.
# Expected: the same from both, since evaluate understands units and unit itself can be called inside an expression. The page on units tells
# what unit does, the page on syntax what evaluate does; neither mentions the other. Heat by the one is in J, by the other in J K^2.
# Seen: 4180 (J K) / kg and 4180 J / (kg K), which are not equal.
source "$(dirname "$0")/common.sh"
npm_packages mathjs@15.2.0
cat >capacity.cjs <<'END'
const {evaluate, unit} = require('mathjs');
const text = '4180 J/kg K';
console.log('unit', unit(text).toString() + ',', 'evaluate', evaluate(text).toString() + ',');
console.log(evaluate(text).equals(unit(text)) ? 'equal' : 'not equal');
END
look_at node capacity.cjs
conclude "unit 4180 (J K) / kg, evaluate 4180 J / (kg K), not equal" "math.js reads \"J/kg K\" as one unit in unit() and as another in evaluate()"
