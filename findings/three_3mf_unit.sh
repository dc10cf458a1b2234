#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Package: three 0.187.0 with linkedom 0.18.12 (npm), which stands in for the browser's reader of XML.
# Behaviour: the loader of 3MF files reads the unit of the model and does not use it: a model in inches is as large as one in millimetres.
# Expected: the same scale for all models, as the loader of AMF files of the same package gives: it scales every unit to millimetres. The
# specification of 3MF lets a model state one of six units. The documentation lists what is supported and says nothing of units.
# Seen: an edge of 2 is 2 long in inches, in metres and in millimetres; as AMF it is 50.8, 2000 and 2.
source "$(dirname "$0")/common.sh"
npm_packages three@0.187.0 linkedom@0.18.12
cat >size.mjs <<'END'
import {DOMParser} from 'linkedom';
import {zipSync, strToU8} from 'three/examples/jsm/libs/fflate.module.js';
import {Box3} from 'three';
import {ThreeMFLoader} from 'three/examples/jsm/loaders/3MFLoader.js';
import {AMFLoader} from 'three/examples/jsm/loaders/AMFLoader.js';

globalThis.DOMParser = DOMParser;
const log = console.log;
console.log = () => {};  // the loaders tell of their work
const corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]], faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];

function threeMF(unit) {
  const vertices = corners.map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`).join('');
  const triangles = faces.map(([a, b, c]) => `<triangle v1="${a}" v2="${b}" v3="${c}"/>`).join('');
  const model = `<?xml version="1.0"?><model unit="${unit}" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">` +
    `<resources><object id="1" type="model"><mesh><vertices>${vertices}</vertices><triangles>${triangles}</triangles></mesh></object>` +
    '</resources><build><item objectid="1"/></build></model>';
  const relations = '<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">' +
    '<Relationship Target="/3D/model.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>' +
    '</Relationships>';
  const file = zipSync({'_rels/.rels': strToU8(relations), '3D/model.model': strToU8(model)});
  return new ThreeMFLoader().parse(file.buffer);
}
function amf(unit) {
  const vertices = corners.map(([x, y, z]) => `<vertex><coordinates><x>${x}</x><y>${y}</y><z>${z}</z></coordinates></vertex>`).join('');
  const triangles = faces.map(([a, b, c]) => `<triangle><v1>${a}</v1><v2>${b}</v2><v3>${c}</v3></triangle>`).join('');
  const text = `<?xml version="1.0"?><amf unit="${unit}"><object id="1"><mesh><vertices>${vertices}</vertices>` +
    `<volume>${triangles}</volume></mesh></object></amf>`;
  return new AMFLoader().parse(strToU8(text).buffer);
}
const length = group => { group.updateMatrixWorld(true); return +new Box3().setFromObject(group).max.x.toFixed(3); };
for (const unit of ['millimeter', 'inch', 'meter']) log(unit, '3MF', length(threeMF(unit)), 'AMF', length(amf(unit)) + ';');
END
look_at node size.mjs
conclude "millimeter 3MF 2 AMF 2; inch 3MF 2 AMF 50.8; meter 3MF 2 AMF 2000;" "three.js ignores the unit of a 3MF file"
