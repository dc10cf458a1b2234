// SPDX-License-Identifier: MIT
// Turns the bodies of the report. One WebGL2 context draws all of them, off screen, and each picture is copied to the canvas of its figure:
// browsers keep about 16 contexts alive. Data stand in the page as base64 of raw deflate pieces, which pack.h describes.
'use strict';
(() => {
// ---- what fields are called and how they are coloured; the stops of maps are those of analysis/image/colour.cpp
const FIELDS = {
  browning: { words: 'as baked' },
  temperature: { words: 'temperature', unit: '°C', of: '°C', scale: 1, row: 0,
    map: '000004 210c4a 57106e 8a226a bc3754 e45a31 f98c0a f9cb35 fcffa4' },
  saturation: { words: 'water', unit: '%', of: '% of the room in pores', scale: 100, row: 1,
    map: '00204d 00306f 2a406c 48526b 5e626e 727374 878479 9e9677 b6a971 d0be67 ead357 ffea46' },
  porosity: { words: 'gas', unit: '%', of: '% of the volume', scale: 100, row: 2,
    map: '440154 472d7b 3b528b 2c728e 21918c 28ae80 5ec962 addc30 fde725' },
};
const AS_BAKED = 'browning', SKIN_ROW = 3, CRUMB_ROW = 4, ROWS = 5, SHADOW = 1024;
const evenly = colours => colours.split(' ').map((c, i, all) => [i / (all.length - 1), c]);
const clamp = (x, low, high) => Math.min(high, Math.max(low, x));

// ---- unpacking
function bytesOf(id) {
  const text = document.getElementById(id).textContent.trim();
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  return Uint8Array.from(atob(text), c => c.charCodeAt(0));
}
async function inflated(piece) {
  const stream = new Blob([piece]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
/// Reads a piece from its start to its end.
class Reader {
  constructor(bytes) { this.bytes = bytes; this.at = 0; }
  planes(count, take) {  // numbers of two bytes: all low ones, then all high ones
    for (let i = 0; i < count; ++i) take(i, this.bytes[this.at + i] | this.bytes[this.at + count + i] << 8);
    this.at += 2 * count;
  }
  signed(count, take) { this.planes(count, (i, u) => take(i, (u >>> 1) ^ -(u & 1))); }
  codes(count, before, take) {  // differences from the code before, or from those of the frame before
    let last = 0;
    for (let i = 0; i < count; ++i) take(i, last = (before ? before(i) : last) + this.bytes[this.at++] & 255);
  }
}
function unpackMesh(bytes, frame, fieldCount) {
  const n = frame.vertices, reader = new Reader(bytes);
  const index = new Uint32Array(3 * frame.triangles), places = new Uint16Array(4 * n), fields = new Uint8Array(4 * n);
  let next = 0;
  reader.planes(index.length, (i, below) => { index[i] = next - below; if (below === 0) ++next; });
  for (let a = 0; a < 3; ++a) { let last = 0; reader.signed(n, (i, d) => { places[4 * i + a] = last += d; }); }
  for (let f = 0; f < fieldCount; ++f) reader.codes(n, null, (i, c) => { fields[4 * i + f] = c; });
  return { index, places, fields, normals: normalsOf(places, index) };
}
function normalsOf(p, index) {
  const sums = new Float32Array(p.length), normals = new Int8Array(p.length);
  for (let t = 0; t < index.length; t += 3) {
    const a = 4 * index[t], b = 4 * index[t + 1], c = 4 * index[t + 2];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    sums[a] += x; sums[a + 1] += y; sums[a + 2] += z; sums[b] += x; sums[b + 1] += y; sums[b + 2] += z;
    sums[c] += x; sums[c + 1] += y; sums[c + 2] += z;
  }
  for (let i = 0; i < p.length; i += 4) {
    const scale = 127 / (Math.hypot(sums[i], sums[i + 1], sums[i + 2]) || 1);
    for (let k = 0; k < 3; ++k) normals[i + k] = sums[i + k] * scale;
  }
  return normals;
}
function unpackParticles(bytes, n, fieldCount, before) {
  const reader = new Reader(bytes), places = new Uint16Array(4 * n), fields = new Uint8Array(4 * n);
  for (let a = 0; a < 3; ++a) {
    let last = 0;
    reader.signed(n, (i, d) => { last = (before ? before.places[4 * i + a] : last) + d; places[4 * i + a] = last; });
  }
  for (let f = 0; f < fieldCount; ++f)
    reader.codes(n, before && (i => before.fields[4 * i + f]), (i, c) => { fields[4 * i + f] = c; });
  return { places, fields };
}
function unpackFields(bytes, nodes, fieldCount) {
  const reader = new Reader(bytes), texels = new Uint8Array(4 * nodes);
  for (let f = 0; f < fieldCount; ++f) reader.codes(nodes, null, (i, c) => { texels[4 * i + f] = c; });
  return texels;
}

// ---- vectors and 4 x 4 matrices by columns
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const unit = v => v.map(x => x / Math.hypot(...v));
const times = (a, b) => Array.from({ length: 16 }, (_, i) => [0, 1, 2, 3].reduce((s, k) => s + a[(i & 3) + 4 * k] * b[4 * (i >> 2) + k], 0));
function looking(eye, at, up) {
  const z = unit(eye.map((e, i) => e - at[i])), x = unit(cross(up, z)), y = cross(z, x);
  return [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -dot(x, eye), -dot(y, eye), -dot(z, eye), 1];
}

// ---- shaders
const COMMON = `#version 300 es
precision highp float; precision highp int; precision highp sampler3D; precision highp sampler2DShadow;
uniform mat4 uView, uLight; uniform vec3 uEye, uSun, uLow, uGrid; uniform vec4 uCut, uTray; uniform vec2 uRange;
uniform float uStep, uRadius, uMix, uHeight; uniform int uField, uRow, uPass; uniform mat3 uTurn;
uniform sampler2D uMaps; uniform sampler3D uInside; uniform sampler2DShadow uShadow;
const int DRAW = 0, SHADE = 1, PICK = 2;`;
const FRAGMENT = `
vec3 colour(int row, float x) { return texture(uMaps, vec2((x * 255. + .5) / 256., (float(row) + .5) / ${ROWS}.)).rgb; }
vec4 inside(vec3 p) { vec3 n = vec3(textureSize(uInside, 0)); return texture(uInside, ((p - uLow) / uGrid * (n - 1.) + .5) / n); }
bool isData(vec4 f) { return f.r > .5 / 255.; }
float hash(vec3 p) { p = fract(p * .3183 + .1) * 17.; return fract(p.x * p.y * p.z * (p.x + p.y + p.z)); }
float noise(vec3 x) {
  vec3 i = floor(x), f = fract(x); f = f * f * (3. - 2. * f);
  vec4 a = vec4(hash(i), hash(i + vec3(0,1,0)), hash(i + vec3(0,0,1)), hash(i + vec3(0,1,1)));
  vec4 b = vec4(hash(i + vec3(1,0,0)), hash(i + vec3(1,1,0)), hash(i + vec3(1,0,1)), hash(i + vec3(1,1,1)));
  vec4 m = mix(a, b, f.x); vec2 n = mix(m.xz, m.yw, f.y); return mix(n.x, n.y, f.z); }
float sunlight(vec3 p, vec3 n) {
  vec4 l = uLight * vec4(p + n * 38. * uStep, 1.); vec3 q = l.xyz * .5 + .5; float s = 0.;
  for (int y = -1; y <= 1; ++y) for (int x = -1; x <= 1; ++x)
    s += texture(uShadow, vec3(q.xy + vec2(x, y) * 2.2 / ${SHADOW}., q.z - .002));
  return s / 9.; }
// What a place looks like: unshaded and as the legend on a cut, shaded a little on the surface; or a look, with grain, that is no data.
vec4 shade(vec4 f, vec3 p, vec3 n, bool crumb) {
  if (uPass == PICK) return f;
  float sun = max(dot(n, uSun), 0.) * sunlight(p, n), sky = .5 + .5 * n.z, share = (f[uField] * 255. - 1.) / 254.;
  if (uRow < ${SKIN_ROW}) {
    vec3 c = colour(uRow, clamp((share - uRange.x) / (uRange.y - uRange.x), 0., 1.));
    return vec4(crumb ? c : c * (.58 + .28 * sun + .2 * sky), 1.); }
  vec3 x = p / (uStep * 4094.);
  float g = noise(x * (crumb ? 170. : 78.)) * .6 + noise(x * 35.) * .4;
  vec3 a = pow(colour(crumb ? ${CRUMB_ROW} : ${SKIN_ROW}, clamp(share + (g - .5) * (crumb ? .05 : .16), 0., 1.)), vec3(2.2));
  if (crumb) a *= .86 + .28 * g;
  vec3 eye = normalize(uEye - p);
  float rim = pow(1. - max(dot(n, eye), 0.), 4.), gloss = crumb ? 0. : pow(max(dot(n, normalize(uSun + eye)), 0.), 24.) * .1;
  vec3 light = vec3(1., .93, .82) * sun * .95 + vec3(.84, .87, .93) * sky * .5 + (crumb ? .2 : .08);
  vec3 c = a * light + .9 * (rim * .05 * sky + gloss * sun);
  return vec4(pow(c / (1. + .12 * c), vec3(1. / 2.2)), 1.); }`;
const MESH_VERTEX = COMMON + `
layout(location=0) in vec3 aPlace; layout(location=1) in vec3 aNormal; layout(location=2) in vec4 aFields; out vec3 p, n; out vec4 f;
void main() { p = uLow + aPlace * uStep; n = aNormal; f = aFields; gl_Position = (uPass == SHADE ? uLight : uView) * vec4(p, 1.); }`;
// Where the far wall is the first that is seen after what lies beyond the cut was thrown away, the eye looks in through the cut: the wall's
// fragment shows the cut's point instead. It keeps the wall's depth, or else it would cover crust behind the plane but before the wall.
const MESH_FRAGMENT = COMMON + FRAGMENT + `
in vec3 p, n; in vec4 f; out vec4 o;
void main() {
  if (dot(uCut.xyz, p) > uCut.w) discard;
  if (uPass == SHADE) { o = vec4(1.); return; }
  vec3 m = normalize(n);
  if (!gl_FrontFacing) {
    vec3 d = p - uEye; float t = (uCut.w - dot(uCut.xyz, uEye)) / dot(uCut.xyz, d); vec3 c = uEye + t * d; vec4 g = inside(c);
    if (uCut.w < 1e8 && t > 0. && t < 1. && isData(g)) { o = shade(g, c, uCut.xyz, true); return; }
    m = -m; }  // a sliver at the outline
  if (uRow >= ${SKIN_ROW} && uPass == DRAW) {
    vec3 x = p / (uStep * 4094.) * 55.; float e = .35, b = noise(x);
    m = normalize(m - .1 * vec3(noise(x + vec3(e,0,0)) - b, noise(x + vec3(0,e,0)) - b, noise(x + vec3(0,0,e)) - b) / e); }
  o = shade(f, p, m, false); }`;
const DOT_VERTEX = COMMON + `
layout(location=0) in vec3 aPlace; layout(location=2) in vec4 aFields;
layout(location=3) in vec3 aNextPlace; layout(location=4) in vec4 aNextFields; out vec3 p; out vec4 f;
void main() {
  p = uLow + mix(aPlace, aNextPlace, uMix) * uStep; f = mix(aFields, aNextFields, uMix);
  gl_Position = (uPass == SHADE ? uLight : uView) * vec4(p, 1.);
  float across = length(vec3(uLight[0][0], uLight[1][0], uLight[2][0]));
  gl_PointSize = uPass == SHADE ? uRadius * ${SHADOW}. * across : uRadius * uHeight / gl_Position.w;
  if (dot(uCut.xyz, p) > uCut.w || max(aPlace.x, aNextPlace.x) > 4094.5) gl_Position = vec4(2., 2., 2., 1.); }  // cut away, or not there`;
const DOT_FRAGMENT = COMMON + FRAGMENT + `
in vec3 p; in vec4 f; out vec4 o;
void main() {
  vec2 s = gl_PointCoord * 2. - 1.; s.y = -s.y; float r = dot(s, s); if (r > 1.) discard;
  vec3 n = uTurn * vec3(s, sqrt(1. - r)), q = p + n * uRadius; vec4 c = uView * vec4(q, 1.);
  gl_FragDepth = uPass == SHADE ? gl_FragCoord.z : c.z / c.w * .5 + .5;
  o = uPass == SHADE ? vec4(1.) : shade(f, q, n, false); }`;
const TRAY_VERTEX = COMMON + `
out vec3 p;
void main() {
  vec2 c = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2. - 1.; p = vec3(uTray.xy + c * uTray.z, uTray.w);
  gl_Position = uView * vec4(p, 1.); }`;
const TRAY_FRAGMENT = COMMON + FRAGMENT + `
in vec3 p; out vec4 o;
void main() {
  float dark = 1. - sunlight(p, vec3(0., 0., 1.)), r = length(p.xy - uTray.xy) / uTray.z;
  o = vec4(0., 0., 0., dark * .42 * smoothstep(1., .5, r)); }`;

// ---- the context
let gl = null, programs, shadow;
function program(vertex, fragment) {
  const made = gl.createProgram(), at = {};
  for (const [type, code] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, code); gl.compileShader(shader); gl.attachShader(made, shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw Error(gl.getShaderInfoLog(shader));
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw Error(gl.getProgramInfoLog(made));
  for (let i = gl.getProgramParameter(made, gl.ACTIVE_UNIFORMS); i-- > 0;) {
    const name = gl.getActiveUniform(made, i).name;
    at[name] = gl.getUniformLocation(made, name);
  }
  return { made, at };
}
function texture(target, inner, size, format, type, data) {
  const made = gl.createTexture();
  gl.bindTexture(target, made); gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  if (target === gl.TEXTURE_3D) gl.texImage3D(target, 0, inner, ...size, 0, format, type, data);
  else gl.texImage2D(target, 0, inner, ...size, 0, format, type, data);
  for (const way of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(target, way, gl.LINEAR);
  for (const way of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T, gl.TEXTURE_WRAP_R]) gl.texParameteri(target, way, gl.CLAMP_TO_EDGE);
  return made;
}
/// Begins drawing if it has not begun; false where there is no WebGL2.
function begin() {
  if (gl) return true;
  const canvas = document.createElement('canvas');
  gl = canvas.getContext('webgl2', { antialias: true, alpha: true });
  if (!gl) return false;
  canvas.addEventListener('webglcontextlost', event => {  // what was uploaded is gone; a new context takes its place
    event.preventDefault(); gl = null;
    for (const body of bodies) { body.kept.clear(); if (body.isNear) body.refresh(); }
  });
  programs = { surface: program(MESH_VERTEX, MESH_FRAGMENT), particles: program(DOT_VERTEX, DOT_FRAGMENT),
    tray: program(TRAY_VERTEX, TRAY_FRAGMENT) };
  const depth = texture(gl.TEXTURE_2D, gl.DEPTH_COMPONENT24, [SHADOW, SHADOW], gl.DEPTH_COMPONENT, gl.UNSIGNED_INT, null);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
  shadow = { depth, frame: gl.createFramebuffer() };
  gl.bindFramebuffer(gl.FRAMEBUFFER, shadow.frame);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);
  gl.drawBuffers([gl.NONE]);
  return true;
}
/// Uploads an attribute with four numbers a vertex, of which `used` are used.
function attribute(place, data, used, type, isShare) {
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer()); gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
  gl.enableVertexAttribArray(place); gl.vertexAttribPointer(place, used, type, isShare, 4 * data.BYTES_PER_ELEMENT, 0);
}
function colourRows(look) {
  const pixels = new Uint8Array(4 * 256 * ROWS), rows = [look.skin, look.crumb];
  for (const field of Object.values(FIELDS)) if (field.map) rows.splice(field.row, 0, evenly(field.map));
  rows.forEach((stops, row) => {
    for (let i = 0; i < 256; ++i) {
      const x = i / 255, k = Math.max(1, stops.findIndex(s => s[0] >= x)), [[x0, c0], [x1, c1]] = [stops[k - 1], stops[k]];
      for (let c = 0; c < 4; ++c) {
        const [low, high] = [c0, c1].map(hex => parseInt(hex.substr(2 * c, 2), 16));
        pixels[4 * (256 * row + i) + c] = c === 3 ? 255 : Math.round(low + (high - low) * clamp((x - x0) / (x1 - x0), 0, 1));
      }
    }
  });
  return texture(gl.TEXTURE_2D, gl.RGBA8, [256, ROWS], gl.RGBA, gl.UNSIGNED_BYTE, pixels);
}
/// The shares of each field's range between which all of its values lie.
function rangesOf(texels) {
  return [0, 1, 2, 3].map(f => {
    let low = 255, high = 1;
    for (let i = f; i < texels.length; i += 4) if (texels[i]) { low = Math.min(low, texels[i]); high = Math.max(high, texels[i]); }
    if (high < low + 2) { low = clamp(low - 1, 1, 253); high = low + 2; }
    return [(low - 1) / 254, (high - 1) / 254];
  });
}

const HOME = { turn: -1.1, lift: .5, far: 1 }, calm = matchMedia('(prefers-reduced-motion: reduce)');
const bodies = [];
class Body {
  constructor(figure) {
    this.figure = figure;
    this.canvas = figure.querySelector('canvas');
    this.paper = this.canvas.getContext('2d');
    this.leader = bodies.find(b => b.figure.id === figure.dataset.leader);
    this.followers = []; this.kept = new Map(); this.drawn = Promise.resolve();
    this.head = JSON.parse(document.getElementById(figure.id + '-head').textContent);
    const { low, high, fields, frames } = this.head;
    this.centre = [0, 1, 2].map(a => low[a] + (high[a] - low[a]) * (a === 2 ? .42 : .5));
    this.size = Math.hypot(...[0, 1, 2].map(a => high[a] - low[a]));
    this.camera = { ...HOME };
    this.state = { time: frames.at(-1).time, field: fields.at(-1).name, cut: false, axis: 'x', place: .6, zoomed: false, shape: 'surface' };
    if (this.leader) { this.leader.followers.push(this); this.camera = this.leader.camera; this.state = this.leader.state; }
  }
  find(selector) { return this.figure.querySelector(selector); }
  fieldNumber() { return this.head.fields.findIndex(f => f.name === this.state.field); }
  /// What was made stays, until the context is lost.
  keep(name, make) {
    if (!this.kept.has(name)) this.kept.set(name, make());
    return this.kept.get(name);
  }
  piece([at, length]) {
    this.bytes ??= bytesOf(this.figure.id + '-bytes');
    return inflated(this.bytes.subarray(at, at + length));
  }
  surface(i) {
    return this.keep('surface' + i, async () => {
      const frame = this.head.frames[i], mesh = unpackMesh(await this.piece(frame.mesh), frame, this.head.fields.length);
      const vertices = gl.createVertexArray();
      gl.bindVertexArray(vertices);
      attribute(0, mesh.places, 3, gl.UNSIGNED_SHORT, false); attribute(1, mesh.normals, 3, gl.BYTE, true);
      attribute(2, mesh.fields, 4, gl.UNSIGNED_BYTE, true);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer()); gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, mesh.index, gl.STATIC_DRAW);
      return { vertices, paint: () => gl.drawElements(gl.TRIANGLES, mesh.index.length, gl.UNSIGNED_INT, 0) };
    });
  }
  unpackedParticles(i) {
    return this.keep('unpacked' + i, async () => {
      const before = i ? await this.unpackedParticles(i - 1) : null, { frames, particles, fields } = this.head;
      return unpackParticles(await this.piece(frames[i].particles), particles, fields.length, before);
    });
  }
  particles(i) {
    return this.keep('particles' + i, async () => {
      const now = await this.unpackedParticles(i), next = await this.unpackedParticles(Math.min(i + 1, this.head.frames.length - 1));
      const vertices = gl.createVertexArray();
      gl.bindVertexArray(vertices);
      attribute(0, now.places, 3, gl.UNSIGNED_SHORT, false); attribute(2, now.fields, 4, gl.UNSIGNED_BYTE, true);
      attribute(3, next.places, 3, gl.UNSIGNED_SHORT, false); attribute(4, next.fields, 4, gl.UNSIGNED_BYTE, true);
      return { vertices, paint: () => gl.drawArrays(gl.POINTS, 0, this.head.particles) };
    });
  }
  inside(i) {
    return this.keep('inside' + i, async () => {
      const { shape } = this.head.grid, nodes = shape[0] * shape[1] * shape[2];
      const texels = unpackFields(await this.piece(this.head.frames[i].fields), nodes, this.head.fields.length);
      return { texels: texture(gl.TEXTURE_3D, gl.RGBA8, shape, gl.RGBA, gl.UNSIGNED_BYTE, texels), ranges: rangesOf(texels) };
    });
  }
  /// The moment that is shown: surfaces jump from frame to frame, particles go from one (`first`) to the next.
  moment() {
    const { frames } = this.head, time = this.state.time;
    let first = frames.length - 1;
    while (first > 0 && frames[first].time > time) --first;
    const next = frames[first + 1], share = next ? clamp((time - frames[first].time) / (next.time - frames[first].time), 0, 1) : 0;
    return { first, share, nearest: share > .5 ? first + 1 : first };
  }
  /// The shares of the field's range between which the colours go, over this body and those beside it.
  range(insides) {
    if (!this.state.zoomed || this.state.field === AS_BAKED) return [0, 1];
    const ranges = insides.map(x => x.ranges[this.fieldNumber()]);
    return [Math.min(...ranges.map(r => r[0])), Math.max(...ranges.map(r => r[1]))];
  }
  view() {
    const { turn, lift, far } = this.camera, wide = this.canvas.width / this.canvas.height;
    const distance = 1.42 * this.size * far * Math.max(1, 1.25 / wide);
    const way = [Math.cos(turn) * Math.cos(lift), Math.sin(turn) * Math.cos(lift), Math.sin(lift)];
    const eye = this.centre.map((c, a) => c + distance * way[a]), look = looking(eye, this.centre, [0, 0, 1]);
    const focal = 1 / Math.tan(.25), near = .2 * distance, end = 3 * distance;
    const lens = [focal / wide, 0, 0, 0, 0, focal, 0, 0, 0, 0, (end + near) / (near - end), -1, 0, 0, 2 * end * near / (near - end), 0];
    return { eye, focal, matrix: times(lens, look), turn: [0, 4, 8, 1, 5, 9, 2, 6, 10].map(k => look[k]) };
  }
  light() {
    const angle = this.camera.turn - .55, sun = unit([.7 * Math.cos(angle), .7 * Math.sin(angle), .8]), r = .6 * this.size;
    const look = looking(this.centre.map((c, a) => c + 2 * r * sun[a]), this.centre, [0, 0, 1]);
    return { sun, matrix: times([1 / r, 0, 0, 0, 0, 1 / r, 0, 0, 0, 0, -1 / (2 * r), 0, 0, 0, -1, 1], look) };
  }
  cutPlane() {  // what is beyond is not shown: the side towards the reader who looks from the front, or above
    const { cut, axis, place } = this.state, a = 'xyz'.indexOf(axis), sign = a === 1 ? -1 : 1, normal = [0, 0, 0];
    if (!cut) return [0, 0, 1, 1e9];
    normal[a] = sign;
    return [...normal, sign * (this.head.low[a] + (this.head.high[a] - this.head.low[a]) * place)];
  }
  /// Draws; with `pick`, a pixel, draws only that, as data, and returns its four bytes.
  async draw(pick) {
    if (!begin()) { this.figure.classList.add('still'); return null; }
    const { first, share, nearest } = this.moment(), dots = this.state.shape === 'particles' && this.head.particles > 0;
    const others = [this.leader ?? this, ...(this.leader ?? this).followers].map(b => b.inside(b.moment().nearest));
    const shape = await (dots ? this.particles(first) : this.surface(nearest)), inside = await this.inside(nearest);
    this.shown = { range: this.range(await Promise.all(others)), time: dots ? this.state.time : this.head.frames[nearest].time };
    if (!gl) return null;  // lost meanwhile; it will be drawn again
    const maps = this.keep('maps', () => colourRows(this.head.look));
    const { width, height } = this.canvas, view = this.view(), light = this.light(), { head } = this;
    if (gl.canvas.width < width) gl.canvas.width = width;
    if (gl.canvas.height < height) gl.canvas.height = height;
    const use = ({ made, at }, pass) => {
      const isBaked = this.state.field === AS_BAKED;
      gl.useProgram(made);
      gl.uniformMatrix4fv(at.uView, false, view.matrix); gl.uniformMatrix4fv(at.uLight, false, light.matrix);
      gl.uniformMatrix3fv(at.uTurn ?? null, false, view.turn);
      for (const [name, value] of Object.entries({ uEye: view.eye, uSun: light.sun, uLow: head.low,
        uGrid: head.grid.shape.map(n => (n - 1) * head.grid.spacing) })) gl.uniform3fv(at[name] ?? null, value);
      gl.uniform4fv(at.uCut ?? null, this.cutPlane());
      gl.uniform4fv(at.uTray ?? null, [this.centre[0], this.centre[1], 1.3 * head.span, head.low[2] - .004 * head.span]);
      gl.uniform2fv(at.uRange ?? null, this.shown.range);
      for (const [name, value] of Object.entries({ uStep: head.span / head.steps, uRadius: head.radius, uMix: share,
        uHeight: height * view.focal })) gl.uniform1f(at[name] ?? null, value);
      for (const [name, value] of Object.entries({ uField: Math.max(0, this.fieldNumber()), uPass: pass, uMaps: 0, uInside: 1, uShadow: 2,
        uRow: isBaked ? SKIN_ROW : FIELDS[this.state.field].row })) gl.uniform1i(at[name] ?? null, value);
      [[gl.TEXTURE_2D, maps], [gl.TEXTURE_3D, inside.texels], [gl.TEXTURE_2D, pass === 1 ? null : shadow.depth]].forEach(([target, t], i) => {
        gl.activeTexture(gl.TEXTURE0 + i); gl.bindTexture(target, t);
      });
    };
    const paint = pass => { use(dots ? programs.particles : programs.surface, pass); gl.bindVertexArray(shape.vertices); shape.paint(); };
    const clear = () => { gl.clearColor(0, 0, 0, 0); gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT); };
    gl.enable(gl.DEPTH_TEST); gl.disable(gl.BLEND); gl.disable(gl.SCISSOR_TEST);
    if (pick) {
      const pixel = new Uint8Array(4);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null); gl.viewport(0, 0, width, height);
      gl.enable(gl.SCISSOR_TEST); gl.scissor(...pick, 1, 1); clear(); paint(2);
      gl.readPixels(...pick, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return pixel;
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, shadow.frame); gl.viewport(0, 0, SHADOW, SHADOW); gl.clear(gl.DEPTH_BUFFER_BIT); paint(1);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null); gl.viewport(0, 0, width, height); clear(); paint(0);
    gl.enable(gl.BLEND); gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    use(programs.tray, 0); gl.bindVertexArray(null); gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    this.paper.clearRect(0, 0, width, height);
    this.paper.drawImage(gl.canvas, 0, gl.canvas.height - height, width, height, 0, 0, width, height);
    this.figure.classList.add('alive');
    return null;
  }
  /// Draws at the next chance, one picture after the other, however often it is asked.
  refresh() {
    for (const follower of this.followers) if (follower.isNear) follower.refresh();
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => {
      this.drawn = this.drawn.then(() => { this.isAsked = false; return this.draw(); }).then(() => this.show(), error => {
        if (gl) { console.error(error); this.figure.classList.add('still'); }
      });
    });
  }
  fit() {
    const box = this.canvas.getBoundingClientRect(), scale = Math.min(devicePixelRatio || 1, 2);
    this.canvas.width = Math.max(2, Math.round(box.width * scale)); this.canvas.height = Math.max(2, Math.round(box.height * scale));
    this.refresh();
  }

  // ---- what readers do
  set(change) {
    const { frames } = this.head, state = Object.assign(this.state, change);
    state.time = clamp(state.time, frames[0].time, frames.at(-1).time); state.place = clamp(state.place, 0, 1);
    this.refresh(); this.remember();
  }
  look(change) {
    Object.assign(this.camera, change);
    this.camera.lift = clamp(this.camera.lift, -.05, 1.5); this.camera.far = clamp(this.camera.far, .35, 2);
    this.refresh(); this.remember();
  }
  turnBy(turn, lift) { this.look({ turn: this.camera.turn - turn, lift: this.camera.lift + lift }); }
  zoomBy(factor) { this.look({ far: this.camera.far * factor }); }
  stepBy(n) { const { frames } = this.head; this.set({ time: frames[clamp(this.moment().nearest + n, 0, frames.length - 1)].time }); }
  play(on = !this.timer) {
    cancelAnimationFrame(this.timer); this.timer = 0;
    if (on && calm.matches) { this.stepBy(this.state.time >= this.head.frames.at(-1).time ? -1e9 : 1); return; }
    const [start, end] = [this.head.frames[0].time, this.head.frames.at(-1).time], seconds = 6;
    let last = 0;
    const tick = now => {
      const time = this.state.time + (last ? Math.min(100, now - last) / 1000 / seconds * (end - start) : 0);
      last = now; this.timer = requestAnimationFrame(tick); this.set({ time: time > end ? start : time });
    };
    if (on) { if (this.state.time >= end) this.state.time = start; this.timer = requestAnimationFrame(tick); }
    this.show();
  }
  /// The state in the address, for links.
  remember() {
    clearTimeout(this.later);
    this.later = setTimeout(() => {
      const s = this.state, { turn, lift, far } = this.camera, n = x => String(+x.toFixed(2));
      history.replaceState(null, '', `#${this.figure.id}&t=${n(s.time)}&by=${s.field}&cut=${s.cut ? s.axis + n(s.place) : 'no'}` +
        `&range=${s.zoomed ? 'now' : 'run'}&shape=${s.shape}&from=${[turn, lift, far].map(n)}`);
    }, 250);
  }
  recall() {
    const [id, ...rest] = decodeURIComponent(location.hash.slice(1)).split('&'), asked = Object.fromEntries(rest.map(r => r.split('=')));
    if (id !== this.figure.id || !rest.length) return;
    const change = {}, from = (asked.from ?? '').split(',').map(Number), cut = /^([xyz])([\d.]+)$/.exec(asked.cut ?? '');
    if (Number.isFinite(parseFloat(asked.t))) change.time = parseFloat(asked.t);
    if (this.head.fields.some(f => f.name === asked.by)) change.field = asked.by;
    if (asked.cut) change.cut = cut !== null;
    if (cut) { change.axis = cut[1]; change.place = Number(cut[2]) || 0; }
    if (asked.range) change.zoomed = asked.range === 'now';
    if (asked.shape) change.shape = asked.shape === 'particles' && this.head.particles ? 'particles' : 'surface';
    if (from.length === 3 && from.every(Number.isFinite)) this.look({ turn: from[0], lift: from[1], far: from[2] });
    this.set(change);
    this.figure.scrollIntoView();
  }
  /// Controls, legend, charts and the words for those who do not see follow the state.
  show() {
    const s = this.state, field = FIELDS[s.field], time = (this.shown?.time ?? s.time).toFixed(1), title = this.figure.dataset.title;
    if (this.leader) { this.canvas.setAttribute('aria-label', `${title}, seen like the body above`); return; }
    const play = this.find('.play'), legend = this.find('.legend'), isBaked = s.field === AS_BAKED;
    play.textContent = this.timer ? '❚❚' : '▶'; play.setAttribute('aria-label', this.timer ? 'pause' : 'play');
    this.find('.time').value = s.time; this.find('.time').setAttribute('aria-valuetext', `${time} seconds`);
    this.find('.now').textContent = `${time} s`;
    for (const choice of this.figure.querySelectorAll('.pills input')) choice.checked = choice.value === s.field;
    this.find('.cut').checked = s.cut; this.find('.place').value = s.place; this.find('.axis').value = s.axis;
    this.find('.place').disabled = this.find('.axis').disabled = !s.cut;
    if (this.find('.shape')) this.find('.shape').value = s.shape;
    this.find('.zoomed').checked = s.zoomed; this.find('.zoomed').disabled = legend.hidden = isBaked;
    if (!isBaked) {
      const { low, high } = this.head.fields[this.fieldNumber()], range = this.shown?.range ?? [0, 1];
      const [from, to] = range.map(share => (low + share * (high - low)) * field.scale);
      this.find('.bar').style.background = `linear-gradient(90deg,${evenly(field.map).map(([x, c]) => `#${c} ${100 * x}%`)})`;
      this.find('.ticks').replaceChildren(...[0, .25, .5, .75, 1].map(x => Object.assign(document.createElement('span'),
        { textContent: (from + x * (to - from)).toFixed(to - from < 8 ? 1 : 0) })));
      this.find('.what').textContent = `${field.words} [${field.of}]`;
    }
    this.canvas.setAttribute('aria-label', `${title}: ${time} seconds, coloured ${isBaked ? 'as baked' : 'by ' + field.words}` +
      `${s.cut ? ', cut across ' + s.axis : ''}. Arrow keys turn it, plus and minus zoom, comma and period step in time, space plays, ` +
      '1 to 4 colour it, c cuts it, brackets move the cut, r puts it back.');
    for (const line of document.querySelectorAll(`[data-follows="${this.figure.id}"] .cursor`)) {
      const { left, right, end } = line.dataset, x = +left + (right - left) * clamp(time / end, 0, 1);
      line.setAttribute('x1', x); line.setAttribute('x2', x);
    }
  }
  /// Reads the values where the pointer is.
  async read(event) {
    const box = this.canvas.getBoundingClientRect(), scale = this.canvas.width / box.width;
    const pick = [Math.floor((event.clientX - box.left) * scale), this.canvas.height - 1 - Math.floor((event.clientY - box.top) * scale)];
    const pixel = await (this.drawn = this.drawn.then(() => this.draw(pick)));
    if (!pixel) return;
    const words = this.head.fields.map((f, i) => {
      const value = f.low + (pixel[i] - 1) / 254 * (f.high - f.low), { words, unit, scale } = FIELDS[f.name];
      return f.name === AS_BAKED ? '' : `${words} ${Math.round(value * scale)} ${unit}`;
    });
    this.find('.reading').textContent = pixel[0] === 0 ? '' : words.filter(Boolean).join(' · ');
  }
  listen() {
    const { canvas } = this, fingers = new Map();
    let gap = 0;
    canvas.addEventListener('pointerdown', e => { fingers.set(e.pointerId, e); canvas.setPointerCapture(e.pointerId); gap = 0; });
    for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, e => fingers.delete(e.pointerId));
    canvas.addEventListener('pointermove', e => {
      const before = fingers.get(e.pointerId);
      if (!before) { if (e.pointerType === 'mouse') this.read(e); return; }
      fingers.set(e.pointerId, e);
      const [a, b] = fingers.values(), apart = b && Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
      if (b) { if (gap) this.zoomBy(gap / apart); gap = apart; return; }
      const up = e.pointerType === 'touch' ? 0 : e.clientY - before.clientY;  // a finger's way up or down scrolls the page
      this.turnBy(.008 * (e.clientX - before.clientX), .008 * up);
    });
    canvas.addEventListener('pointerleave', () => { this.find('.reading').textContent = ''; });
    canvas.addEventListener('click', e => this.read(e));
    canvas.addEventListener('wheel', e => {  // never takes the page's wheel unasked
      if (!e.ctrlKey && document.activeElement !== canvas) return;
      e.preventDefault(); this.zoomBy(Math.exp(.0015 * e.deltaY));
    }, { passive: false });
    canvas.addEventListener('dblclick', () => this.look(HOME));
    const by = field => () => { if (this.head.fields.some(f => f.name === field)) this.set({ field }); };
    const keys = {
      ArrowLeft: () => this.turnBy(.12, 0), ArrowRight: () => this.turnBy(-.12, 0), ArrowUp: () => this.turnBy(0, .1),
      ArrowDown: () => this.turnBy(0, -.1), '+': () => this.zoomBy(.9), '=': () => this.zoomBy(.9), '-': () => this.zoomBy(1 / .9),
      ',': () => this.stepBy(-1), '.': () => this.stepBy(1), ' ': () => this.play(), c: () => this.set({ cut: !this.state.cut }),
      '[': () => this.set({ cut: true, place: this.state.place - .03 }), ']': () => this.set({ cut: true, place: this.state.place + .03 }),
      r: () => this.look(HOME), 1: by('browning'), 2: by('temperature'), 3: by('saturation'), 4: by('porosity'),
    };
    canvas.addEventListener('keydown', e => {
      if (e.ctrlKey || e.metaKey || e.altKey || !keys[e.key]) return;
      e.preventDefault(); keys[e.key]();
    });
    const on = (selector, event, change) => this.find(selector)?.addEventListener(event, e => this.set(change(e.target)));
    this.find('.play').addEventListener('click', () => this.play());
    this.find('.time').addEventListener('input', () => this.play(false));
    on('.time', 'input', x => ({ time: +x.value })); on('.pills', 'change', x => ({ field: x.value }));
    on('.cut', 'change', x => ({ cut: x.checked })); on('.place', 'input', x => ({ place: +x.value }));
    on('.axis', 'change', x => ({ axis: x.value })); on('.zoomed', 'change', x => ({ zoomed: x.checked })); on('.shape', 'change', x => ({ shape: x.value }));
    for (const chart of document.querySelectorAll(`[data-follows="${this.figure.id}"]`))
      chart.addEventListener('click', e => {
        const { left, right, end } = chart.querySelector('.cursor').dataset, place = chart.getScreenCTM();
        this.set({ time: ((e.clientX - place.e) / place.a - left) / (right - left) * end });
      });
    addEventListener('hashchange', () => this.recall());
  }
}

// ---- the page
for (const figure of document.querySelectorAll('figure.body')) bodies.push(new Body(figure));
const near = new IntersectionObserver(entries => {
  for (const entry of entries) {
    if (!entry.isIntersecting) continue;
    near.unobserve(entry.target);
    const body = bodies.find(b => b.figure === entry.target);
    body.isNear = true;
    new ResizeObserver(() => body.fit()).observe(body.canvas);
  }
}, { rootMargin: '300px' });
for (const body of bodies) {
  near.observe(body.figure);
  if (!body.leader) { body.listen(); body.show(); body.recall(); }
}
const unfold = () => {
  const target = document.getElementById(location.hash.slice(1).split('&')[0]);
  (target?.closest('details') ?? target?.querySelector(':scope > details'))?.setAttribute('open', '');
};
addEventListener('hashchange', unfold); unfold();
addEventListener('beforeprint', () => { for (const fold of document.querySelectorAll('details')) fold.open = true; });
for (const button of document.querySelectorAll('button.copy')) {
  button.hidden = !navigator.clipboard;
  button.addEventListener('click', async () => {
    await navigator.clipboard.writeText(button.dataset.copy);
    button.textContent = 'copied'; setTimeout(() => { button.textContent = 'copy'; }, 1500);
  });
}
window.bodies = bodies;  // for tests and the curious
window.loseContext = () => gl?.getExtension('WEBGL_lose_context').loseContext();
})();
