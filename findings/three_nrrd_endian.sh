#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: three 0.187.0 (npm).
# Behaviour: NRRDLoader reads raw data of a volume always as little-endian; the field "endian" of the header is kept and not used.
# Expected: the numbers that were written, as the field is there for nothing else and the format requires it for raw data of more than one
# byte. Or a refusal. The documentation names no limitation.
# Seen: the shorts 1, 2, 3, 400 are read as 1, 2, 3, 400 from a little-endian file and as 256, 512, 768, -28671 from a big-endian one.
source "$(dirname "$0")/common.sh"
npm_packages three@0.187.0
cat >read.mjs <<'END'
import {NRRDLoader} from 'three/examples/jsm/loaders/NRRDLoader.js';
const values = [1, 2, 3, 400];
for (const order of ['little', 'big']) {
  const header = new TextEncoder().encode(
    `NRRD0004\ntype: short\ndimension: 3\nsizes: 4 1 1\nspacings: 1 1 1\nendian: ${order}\nencoding: raw\n\n`);
  const bytes = new Uint8Array(header.length + 2 * values.length);
  bytes.set(header);
  values.forEach((value, i) => new DataView(bytes.buffer).setInt16(header.length + 2 * i, value, order === 'little'));
  console.log(order + ':', new NRRDLoader().parse(bytes.buffer).data.join() + ';');
}
END
look_at node read.mjs
conclude "little: 1,2,3,400; big: 256,512,768,-28671;" "three.js reads a big-endian NRRD volume as a little-endian one"
