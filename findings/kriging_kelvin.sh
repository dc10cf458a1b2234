#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: @sakitam-gis/kriging 0.1.0 (npm).
# Behaviour: temperatures between measured points differ by other than 273.15 if the same data are in kelvin instead of degrees Celsius.
# The weights of the data do not add up to one; at the points themselves the data return.
# Expected: the same temperatures. The README names the method ordinary kriging, whose weights add up to one (it differs from simple kriging
# by this) so that a constant added to the data is added to the result, and a constant field stays. The variogram is made of differences.
# The README's formulas take a mean of 0, and nothing is said of what follows for data far from it.
# Seen: between measurements of 20 to 23 degrees, with the model of the README's example, 23.9 degrees; from kelvin 325.8, which is 52.6
# degrees. A field of 20 everywhere is 0 between and also at the measured points.
source "$(dirname "$0")/common.sh"
npm_packages @sakitam-gis/kriging@0.1.0
cat >oven.cjs <<'END'
const {train, predict} = require('@sakitam-gis/kriging');
const x = [0, 4, 0, 4, 2, 1, 3], y = [0, 0, 4, 4, 2, 3, 1], celsius = [20, 21, 22, 23, 21.5, 21.2, 21.9];
const at = (values, x_of_point, y_of_point) => predict(x_of_point, y_of_point, train(values, x, y, 'exponential', 0, 100));
const kelvin = celsius.map(value => value + 273.15), constant = celsius.map(() => 20);
console.log('measured point:', at(celsius, 2, 2).toFixed(1), (at(kelvin, 2, 2) - 273.15).toFixed(1), at(constant, 2, 2).toFixed(1) + ';');
console.log('between:', at(celsius, 2, 3).toFixed(1), (at(kelvin, 2, 3) - 273.15).toFixed(1), at(constant, 2, 3).toFixed(1));
END
look_at node oven.cjs
conclude "measured point: 21.5 21.5 0.0; between: 23.9 52.6 0.0" "kriging gives other temperatures in kelvin than in degrees Celsius"
