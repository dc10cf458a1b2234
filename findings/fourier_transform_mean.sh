#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: fourier-transform 2.5.0 (npm).
# Behaviour: the first entry of the magnitude spectrum, that of frequency 0, is twice the mean of the signal, while every other entry is
# the amplitude of its wave.
# Expected: the mean itself. The readme states the scale: a cosine of amplitude 1 at bin k gives 1 there, and at bin 0 this cosine is
# the constant 1. The factor of 2 over N is right for the bins that have a mirror image, which bin 0 has not.
# Seen: for a signal of mean 3 with a wave of amplitude 2 in bin 5 the spectrum is 6 in bin 0 and 2 in bin 5.
source "$(dirname "$0")/common.sh"
npm_packages fourier-transform@2.5.0
cat >spectrum.mjs <<'END'
import spectrum from 'fourier-transform';
const signal = Array.from({length: 64}, (_, i) => 3 + 2 * Math.cos(2 * Math.PI * 5 * i / 64));
const magnitudes = spectrum(signal);
console.log('bin 0:', magnitudes[0].toFixed(6), 'bin 5:', magnitudes[5].toFixed(6));
END
look_at node spectrum.mjs
conclude "bin 0: 6.000000 bin 5: 2.000000" "the spectrum of fourier-transform has twice the mean of the signal at frequency 0"
