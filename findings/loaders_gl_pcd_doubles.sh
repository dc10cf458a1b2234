#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: @loaders.gl/pcd 4.4.2 with @loaders.gl/core 4.5.4, and three 0.187.0 (npm).
# Behaviour: the PCD loader of loaders.gl takes every coordinate of a binary file for a float of four bytes, although the SIZE line of the
# header says eight: it reads the first half of each double.
# Expected: the coordinates, as three.js reads them, or a refusal. SIZE is there to tell the width, the format allows 8 for type F, and the
# loader uses it to find where the next point begins. The source names one limitation, on compressed files.
# Seen: of the points (1, 2, 3) and (4, 5, 6), in doubles, loaders.gl makes two points at the origin. The same file in floats is right.
source "$(dirname "$0")/common.sh"
npm_packages @loaders.gl/pcd@4.4.2 @loaders.gl/core@4.5.4 three@0.187.0
cat >read.mjs <<'END'
import {parse} from '@loaders.gl/core';
import {PCDLoader} from '@loaders.gl/pcd';
import {PCDLoader as PCDLoaderOfThree} from 'three/examples/jsm/loaders/PCDLoader.js';

function file(numbers, size) {
  const header = new TextEncoder().encode(`# .PCD v0.7\nVERSION 0.7\nFIELDS x y z\nSIZE ${size} ${size} ${size}\nTYPE F F F\n` +
    'COUNT 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\nDATA binary\n');
  const bytes = new Uint8Array(header.length + numbers.byteLength);
  bytes.set(header);
  bytes.set(new Uint8Array(numbers.buffer), header.length);
  return bytes.buffer;
}
const points = [1, 2, 3, 4, 5, 6];
for (const [name, data] of [['floats:', file(new Float32Array(points), 4)], ['doubles:', file(new Float64Array(points), 8)]]) {
  const mesh = await parse(data, PCDLoader, {worker: false});
  const cloud = new PCDLoaderOfThree().parse(data);
  console.log(name, 'loaders.gl', mesh.attributes.POSITION.value.join(), 'three.js', cloud.geometry.attributes.position.array.join());
}
END
look_at node read.mjs
conclude "floats: loaders.gl 1,2,3,4,5,6 three.js 1,2,3,4,5,6 doubles: loaders.gl 0,0,0,0,0,0 three.js 1,2,3,4,5,6" \
  "loaders.gl reads the doubles of a binary PCD file as floats"
