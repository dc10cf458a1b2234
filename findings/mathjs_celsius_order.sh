#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: mathjs 15.2.0 (npm).
# Behaviour: temperatures in different units are compared by their bare numbers times the size of the degree: 20 degC equals 20 K, is not
# 293.15 K and is less than 100 K.
# Expected: 20 degC equals 293.15 K and is more than 100 K: `to` converts so in both directions. The page on units says that units are equal
# if their values in SI units are, and warns of arithmetic with degC because the kelvins count. "Hotter than 300 K" is false for 150 degC.
# Seen: to gives 293.15 K; == 293.15 K false, == 20 K true, > 100 K false.
source "$(dirname "$0")/common.sh"
npm_packages mathjs@15.2.0
cat >compare.cjs <<'END'
const {evaluate} = require('mathjs');
for (const rest of ['to K', '== 293.15 K', '== 20 K', '> 100 K']) console.log(rest + ':', evaluate('20 degC ' + rest).toString() + ';');
END
look_at node compare.cjs
conclude "to K: 293.15 K; == 293.15 K: false; == 20 K: true; > 100 K: false;" "math.js compares 20 degC with kelvins as if it were 20 K"
