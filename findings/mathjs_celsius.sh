#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: mathjs 15.2.0 (npm).
# Behaviour: the difference of two temperatures in degC is one more temperature in degC. Where it is multiplied it counts as a difference,
# where it is converted as a point of the scale: 30 degC - 20 degC is 10 K in a product and 283.15 K after "to K". A difference in K
# becomes -263.15 when it is converted to degC.
# Expected: 10 K each time, or a refusal, as pint gives for such arithmetic. The page on units lists degC beside K without a word on
# differences; issues 2499 and 3134 of the project discuss it.
# Seen: heat 41800 J, difference 283.15 K, heat by the converted difference 1183567 J, back to degC -263.15 degC.
source "$(dirname "$0")/common.sh"
npm_packages mathjs@15.2.0
cat >heat.cjs <<'END'
const {evaluate} = require('mathjs');
for (const text of [
  'number(4180 J/(kg K) * 1 kg * (30 degC - 20 degC), J)',
  '(30 degC - 20 degC) to K',
  'round(number(4180 J/(kg K) * 1 kg * ((30 degC - 20 degC) to K), J))',
  '(303.15 K - 293.15 K) to degC',
]) console.log(String(evaluate(text)) + ';');
END
look_at node heat.cjs
conclude "41800; 283.15 K; 1183567; -263.15 degC;" "a difference of temperatures in mathjs is 10 K or 283.15 K, depending on what is done with it"
