#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Packages: @kitware/vtk.js 37.4.3 and three 0.187.0 (npm). The file in this script is what vtkPolyDataWriter of VTK 9.1 writes: one square.
# Behaviour: version 5.1 of the legacy format, which VTK writes since release 9, stores cells as offsets and connectivity. The reader of
# vtk.js takes the offsets for the cells, without a word, and the loader of three.js gives a geometry without points.
# Expected: the square, or a refusal, since the first line of the file names the version. vtk.js comes from the makers of VTK.
# Seen: vtk.js reads "0 0 0 4" for the square's "4 0 1 2 3", as it does if the file is version 4.2; three.js reads no point.
source "$(dirname "$0")/common.sh"
npm_packages @kitware/vtk.js@37.4.3 three@0.187.0
title=$(printf 'The loader of three.js takes files of less than 250 bytes for damaged ones, hence a long title. %.0s' 1 2)
cat >new.vtk <<END
# vtk DataFile Version 5.1
$title
ASCII
DATASET POLYDATA
POINTS 4 float
0 0 0 1 0 0 1 1 0
0 1 0
POLYGONS 2 4
OFFSETS vtktypeint64
0 4
CONNECTIVITY vtktypeint64
0 1 2 3
END
cat >old.vtk <<END
# vtk DataFile Version 4.2
$title
ASCII
DATASET POLYDATA
POINTS 4 float
0 0 0 1 0 0 1 1 0
0 1 0
POLYGONS 1 5
4 0 1 2 3
END
cat >read.mjs <<'END'
import fs from 'fs';
import vtkPolyDataReader from '@kitware/vtk.js/IO/Legacy/PolyDataReader.js';
import {VTKLoader} from 'three/examples/jsm/loaders/VTKLoader.js';
console.warn = () => {};
for (const name of ['old.vtk', 'new.vtk']) {
  const reader = vtkPolyDataReader.newInstance();
  reader.parseAsText(fs.readFileSync(name, 'latin1'));
  const bytes = fs.readFileSync(name);
  const geometry = new VTKLoader().parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  const cells = [...reader.getOutputData().getPolys().getData()].join(' ');
  console.log(name, 'vtk.js', cells, 'three', geometry.attributes.position?.count ?? 0);
}
END
look_at node read.mjs
conclude "old.vtk vtk.js 4 0 1 2 3 three 4 new.vtk vtk.js 0 0 0 4 three 0" \
  "readers of vtk.js and three.js take a VTK 9 legacy file for something else, silently"
