#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: jsfive 0.4.2 and h5wasm 0.10.3 (npm), and python3-h5py-serial 3.7.0-8 to make the file.
# Behaviour: jsfive does not apply the fill value: elements of chunks that were never written are holes in the array, and a chunked dataset
# in which nothing was written is an array of length 0, whatever its shape says.
# Expected: the fill value, as HDF5's own library gives (here compiled as h5wasm); the file format stores it for that purpose. A mean over
# the array is wrong without an error, as reduce and forEach pass over holes. The readme does not list it among the limitations.
# Seen: h5wasm reads -1,-1,5,6 and -1,-1,-1,-1; jsfive reads two holes before 5,6, and no element at all for the shape of 4.
source "$(dirname "$0")/common.sh"
npm_packages jsfive@0.4.2 h5wasm@0.10.3
debian_packages python3-h5py-serial=3.7.0-8 python3-h5py=3.7.0-8
cat >file.py <<'END'
import h5py

with h5py.File("partly.h5", "w") as file:
    file.create_dataset("partly", (4,), "f8", chunks=(2,), fillvalue=-1.0)[2:] = 5, 6
    file.create_dataset("never", (4,), "f8", chunks=(2,), fillvalue=-1.0)
END
"$python" file.py || cannot_try "h5py does not work"
cat >read.mjs <<'END'
import fs from 'fs';
import h5wasm from 'h5wasm/node';
import {File} from 'jsfive';
await h5wasm.ready;
const bytes = fs.readFileSync('partly.h5');
const file = new File(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length), 'partly.h5');
const same = new h5wasm.File('partly.h5', 'r');
for (const name of ['partly', 'never']) {
  console.log(name, 'h5wasm', same.get(name).value.join());
  console.log(name, 'jsfive', file.get(name).value.join(), 'of shape', file.get(name).shape.join());
}
END
look_at node read.mjs
conclude "partly h5wasm -1,-1,5,6 partly jsfive ,,5,6 of shape 4 never h5wasm -1,-1,-1,-1 never jsfive  of shape 4" \
  "jsfive reads HDF5 elements that were never written as holes or as an empty array, not as the fill value"
