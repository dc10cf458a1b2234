#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: @iarna/toml 3.0.0 (npm).
# Behaviour: stringify writes a small number with one digit, such as 1e-7, with the word undefined behind it. No TOML reader takes that, its
# own parse neither. Numbers down to 1e-6, and those with more digits, such as 1.5e-7, are written right.
# Expected: 1e-7, which TOML allows without a fraction and which the package itself reads; infinity, NaN and 1e21 are written right. Time
# steps and tolerances are such numbers.
# Seen: 1.5e-7 is read back; 1e-7 is written as 1e-7.undefined and refused.
source "$(dirname "$0")/common.sh"
npm_packages @iarna/toml@3.0.0
cat >write.cjs <<'END'
const {parse, stringify} = require('@iarna/toml');
for (const step of [1.5e-7, 1e-7]) {
  const text = stringify({step});
  let read = 'refused';
  try { read = parse(text).step === step ? 'read back' : 'changed'; } catch (error) {}
  console.log(text.trim(), read);
}
END
look_at node write.cjs
conclude "step = 1.5e-7 read back step = 1e-7.undefined refused" "@iarna/toml writes 1e-7 as a text that no TOML reader takes"
