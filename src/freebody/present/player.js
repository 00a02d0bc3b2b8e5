// A motion on a canvas. data: as `page.py` writes it; shown: what the page around it decides, read at every drawing:
// isDark(), hasNames(), isPlaying(), isHeld() if anything can be, head of what lies over the top [px], axes(length) in words, traced (a set of points by number), selected (a set of labels), overlays() if
// anything is drawn over the motion, with quantity(value, unit) in words and lit(arrow), hasGhosts() where bodies are
// shown at other times as well, drawn(frame, time)
function playerOn(canvas, data, shown) {
const pen = canvas.getContext("2d");
let last = data.n_frames - 1, at = 0, view = null, taken = [];

// -- places at a frame, which may lie between two
let n_moving = data.names.length, stride = data.planar ? 3 : 7;
function column(k, f) {
  const track = data.columns[k], i = Math.min(Math.floor(f), last), j = Math.min(i + 1, last);
  return track[i] + (f - i) * (track[j] - track[i]);
}
function quaternion(body, f) {
  // along the shorter turn between two frames
  const i = Math.min(Math.floor(f), last), j = Math.min(i + 1, last), s = f - i;
  const p = [3, 4, 5, 6].map((c) => data.columns[stride * body + c][i]);
  let q = [3, 4, 5, 6].map((c) => data.columns[stride * body + c][j]), cosine = p.reduce((sum, c, k) => sum + c * q[k], 0);
  if (cosine < 0) { q = q.map((c) => -c); cosine = -cosine; }
  const h = Math.acos(Math.min(1, cosine)), sine = Math.sin(h);
  const a = sine < 1e-6 ? 1 - s : Math.sin((1 - s) * h) / sine, b = sine < 1e-6 ? s : Math.sin(s * h) / sine;
  const mixed = p.map((c, k) => a * c + b * q[k]), size = Math.hypot(...mixed) || 1;
  return mixed.map((c) => c / size);
}
let begun = null; // the columns of another start, until its motion is there
let known = { frame: -1, poses: [] }; // of the frame that is drawn, which all strokes ask for
function pose(body, f) {
  if (f !== known.frame) return poseAt(body, f);
  return (known.poses[body] ??= poseAt(body, f));
}
function poseAt(body, f) {
  // the centre and the rows of the rotation
  if (body >= n_moving) return data.fixed[body - n_moving];
  const at = (c) => (begun && f === 0 ? begun[stride * body + c] : column(stride * body + c, f));
  if (data.planar) {
    const c = Math.cos(at(2)), s = Math.sin(at(2));
    return [[at(0), at(1), 0], [[c, -s, 0], [s, c, 0], [0, 0, 1]]];
  }
  const [w, x, y, z] = quaternion(body, f);
  return [[at(0), at(1), at(2)], [
    [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ]];
}
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const l = Math.hypot(...a) || 1; return a.map((c) => c / l); };
const turned = (R, p) => [dot(R[0], p), dot(R[1], p), dot(R[2], p)];
const plus = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
function position(place, f) {
  // place: the body, and where in it
  const [center, R] = pose(place[0], f), [, x, y, z] = place;
  return center.map((c, k) => c + R[k][0] * x + R[k][1] * y + R[k][2] * z);
}
function frameAlong(w) {
  // rows of a right-handed frame whose third is w
  const u0 = Math.abs(w[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0], s = dot(u0, w), u = unit(u0.map((c, k) => c - s * w[k]));
  return [u, cross(w, u), w];
}

// -- the view; the plane is seen along z
const camera = { azimuth: 0, elevation: 0, zoom: 1, shift: [0, 0], axes: null };
function look(azimuth, elevation) {
  const a = azimuth * Math.PI / 180, e = Math.max(-89.9, Math.min(89.9, elevation)) * Math.PI / 180;
  const [front, right, up] = data.frame;
  const mix = (p, u, q, v) => u.map((c, k) => p * c + q * v[k]);
  const towards = mix(Math.cos(e), mix(Math.cos(a), front, Math.sin(a), right), Math.sin(e), up);
  const across = mix(Math.cos(a), right, -Math.sin(a), front);
  Object.assign(camera, { azimuth, elevation: e * 180 / Math.PI, axes: [across, cross(towards, across), towards] });
}
function seen(p) {
  const m = data.middle, local = turned(camera.axes, [p[0] - m[0], p[1] - m[1], p[2] - m[2]]);
  if (!data.distance) return local;
  const grown = data.distance / (data.distance - Math.min(local[2], 0.9 * data.distance));
  return local.map((c) => grown * c);
}

// -- pieces as they are seen
function shot(piece, poses) {
  const at = plus(poses[piece.place[0]][0], turned(poses[piece.place[0]][1], piece.place.slice(1)));
  let place;
  if (piece.end) {
    const end = plus(poses[piece.end[0]][0], turned(poses[piece.end[0]][1], piece.end.slice(1)));
    const way = end.map((c, k) => c - at[k]), [u, v] = frameAlong(Math.hypot(...way) > 1e-12 ? unit(way) : [0, 0, 1]);
    place = (p) => seen(at.map((c, k) => c + p[0] * u[k] + p[1] * v[k] + p[2] * way[k]));
  } else {
    const R = poses[piece.turn][1];
    place = (p) => seen(plus(at, turned(R, p)));
  }
  const points = piece.points.map(place), lines = piece.lines.map((line) => line.map(place));
  if (piece.radius) {
    const edge = seen(at.map((c, k) => c + piece.radius * camera.axes[0][k]));
    const radius = Math.hypot(edge[0] - points[0][0], edge[1] - points[0][1]);
    return closed({ piece, points, lines, normals: [], radius, outline: disc(points[0], radius, 24), depth: points[0][2] });
  }
  const normals = piece.faces.map((face) => {
    const o = points[face[0]], n = [0, 0, 0];
    for (let k = 1; k + 1 < face.length; k++) {
      const c = cross(points[face[k]].map((v, i) => v - o[i]), points[face[k + 1]].map((v, i) => v - o[i]));
      n[0] += c[0]; n[1] += c[1]; n[2] += c[2];
    }
    return n;
  });
  const depth = points.reduce((sum, p) => sum + p[2], 0) / points.length;
  return closed({ piece, points, lines, normals, outline: hull(points), depth, radius: 0 });
}
function closed(taken) {
  taken.owner = data.looks[taken.piece.look].of_body ? taken.piece.turn : -1;
  taken.isArea = true;
  const xs = taken.outline.map((p) => p[0]), ys = taken.outline.map((p) => p[1]);
  taken.box = [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
  return taken;
}
function disc([x, y], radius, n) {
  return Array.from({ length: n }, (_, k) => [x + radius * Math.cos(2 * Math.PI * k / n), y + radius * Math.sin(2 * Math.PI * k / n)]);
}
function hull(points) {
  const ordered = points.map(([x, y]) => [x, y]).sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const chain = (list) => {
    const kept = [];
    for (const p of list) {
      while (kept.length > 1) {
        const a = kept[kept.length - 2], b = kept[kept.length - 1];
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 1e-15) break;
        kept.pop();
      }
      kept.push(p);
    }
    kept.pop();
    return kept;
  };
  return [...chain(ordered), ...chain(ordered.reverse())];
}

// -- strokes of the plane, which lie on each other in their order
const shapes = {
  path(stroke, f) {
    const at = position(stroke.place, f), R = pose(stroke.turn, f)[1];
    return stroke.points.map(([u, v]) => plus(at, turned(R, [u, v, 0])));
  },
  stretch(stroke, f) {
    const a = position(stroke.first, f), b = position(stroke.second, f), dx = b[0] - a[0], dy = b[1] - a[1];
    const l = Math.hypot(dx, dy) || 1, s = Math.min(1, (stroke.longest ?? l) / l);  // a buffer that is not touched
    const to = stroke.against && turned(pose(stroke.turn, f)[1], [...stroke.against, 0]);
    const [ex, ey] = to ? [-to[0], -to[1]] : [-dy / l, dx / l];
    return stroke.points.map(([u, v]) => [a[0] + s * u * dx + v * ex, a[1] + s * u * dy + v * ey, 0]);
  },
  strand(stroke, f) {
    const n = stroke.n_leads, lead = (k) => column(stride * n_moving + stroke.lead + k, f), points = [];
    stroke.nodes.forEach(({ place, arm, drum }, k) => {
      const before = k > 0 ? lead(k - 1) : stroke.closed ? lead(n - 1) : stroke.comes ?? null;
      const after = k < n ? lead(k) : stroke.closed ? lead(0) : null;
      const sense = Math.sign(arm), wound = drum ? sense * 1.5 * Math.PI : 0;
      const into = before !== null ? before : after - wound, out = after !== null ? after : before + wound;
      let turn = ((sense * (out - into)) % (2 * Math.PI) + 2 * Math.PI) % (2 * Math.PI);
      turn = drum ? wound : turn > 1.8 * Math.PI ? 0 : sense * turn;
      const parts = arm ? Math.max(1, Math.ceil(Math.abs(turn) / 0.1)) : 0;
      const [cx, cy] = position(place, f);
      for (let i = 0; i <= parts; i++) {
        const a = into + (parts ? turn * i / parts : 0);
        points.push([cx + arm * Math.sin(a), cy - arm * Math.cos(a), 0]);
      }
    });
    if (stroke.whole === undefined) return points;
    // a free first end: as long as is left of the whole
    const laid = points.slice(1).reduce((sum, p, k) => sum + Math.hypot(p[0] - points[k][0], p[1] - points[k][1]), 0);
    const [x, y] = points[0], left = Math.max(0, stroke.whole - laid);
    return [[x - left * Math.cos(stroke.comes), y - left * Math.sin(stroke.comes), 0], ...points];
  },
};
function flat(stroke, f) {
  const points = shapes[stroke.shape](stroke, f).map(seen), isArea = stroke.closed && stroke.shape !== "strand";
  return { stroke, points, isArea, owner: stroke.owner, outline: isArea && points.length > 2 ? hull(points) : points };
}

// -- what is in front of what: by one line of sight through the middle of where two pieces overlap
function overlap(a, b) {
  let kept = a;
  for (let i = 0; i < b.length && kept.length; i++) {
    const p = b[i], q = b[(i + 1) % b.length], found = [];
    const side = ([x, y]) => (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
    for (let k = 0; k < kept.length; k++) {
      const now = kept[k], after = kept[(k + 1) % kept.length], s = side(now), t = side(after);
      if (s >= 0) found.push(now);
      if (s * t < 0) found.push([now[0] + s / (s - t) * (after[0] - now[0]), now[1] + s / (s - t) * (after[1] - now[1])]);
    }
    kept = found;
  }
  return kept;
}
function area(outline) {
  return 0.5 * outline.reduce((sum, p, k) => { const q = outline[(k + 1) % outline.length]; return sum + p[0] * q[1] - q[0] * p[1]; }, 0);
}
function depths(taken, [x, y]) {
  if (taken.radius) {
    const [cx, cy, cz] = taken.points[0], half = Math.sqrt(Math.max(0, taken.radius ** 2 - (x - cx) ** 2 - (y - cy) ** 2));
    return [cz - half, cz + half];
  }
  let back = -Infinity, front = Infinity;
  taken.normals.forEach((n, k) => {
    if (Math.abs(n[2]) <= 1e-6 * Math.hypot(...n)) return;
    const p = taken.points[taken.piece.faces[k][0]], depth = p[2] + (n[0] * (p[0] - x) + n[1] * (p[1] - y)) / n[2];
    if (n[2] > 0) front = Math.min(front, depth); else back = Math.max(back, depth);
  });
  if (front === Infinity) front = taken.depth;
  return [back === -Infinity ? front : back, front];
}
function compare(a, b) {
  const both = overlap(a.outline, b.outline);
  if (both.length < 3 || Math.abs(area(both)) < 1e-6 * Math.min(area(a.outline), area(b.outline))) return 0;
  const at = [0, 1].map((c) => both.reduce((sum, p) => sum + p[c], 0) / both.length);
  const [backA, frontA] = depths(a, at), [backB, frontB] = depths(b, at);
  const slack = 1e-6 * (frontA - backA + frontB - backB);
  if (backA >= frontB - slack) return 1;
  if (backB >= frontA - slack) return -1;
  return frontA > frontB ? 1 : -1;
}
function backToFront(all) {
  all.sort((a, b) => a.depth - b.depth);
  const behind = all.map(() => []);
  for (let i = 0; i < all.length; i++) {
    for (let j = i + 1; j < all.length; j++) {
      const a = all[i].box, b = all[j].box;
      if (a[0] >= b[2] || b[0] >= a[2] || a[1] >= b[3] || b[1] >= a[3]) continue;
      const sign = compare(all[i], all[j]);
      if (sign > 0) behind[i].push(j); else if (sign < 0) behind[j].push(i);
    }
  }
  const order = [], done = new Set();
  const visit = (k) => {
    if (done.has(k)) return;
    done.add(k);
    behind[k].sort((a, b) => a - b).forEach(visit);
    order.push(all[k]);
  };
  all.forEach((_, k) => visit(k));
  return order;
}

// -- drawing
function theme() { return data.themes[shown.isDark() ? "dark" : "light"]; }
function color(name, body) { const t = theme(); return name === "body" ? t.bodies[body % t.bodies.length] : t[name]; }
function mixed(name, body, share) {
  const parts = [color(name, body), theme().paper].map((hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16)));
  return "rgb(" + parts[0].map((c, k) => Math.round(share * c + (1 - share) * parts[1][k])).join(",") + ")";
}
function onPaper([x, y]) { return [view.x + view.scale * x, view.y - view.scale * y]; }
function way(points, isClosed) {
  pen.beginPath();
  for (const p of points) pen.lineTo(...onPaper(p));
  if (isClosed) pen.closePath();
}
let veil = 1; // of what is drawn at other times than the one that is shown
function fill(points, paint, alpha) {
  way(points, true);
  pen.globalAlpha = veil * alpha;
  pen.fillStyle = paint;
  pen.fill();
  pen.globalAlpha = 1;
}
function rule(paint, width, alpha, dashes = []) {
  pen.strokeStyle = paint;
  pen.lineWidth = 1.25 * width;
  pen.globalAlpha = veil * alpha;
  pen.setLineDash(dashes.map((d) => 1.25 * d));
  pen.stroke();
  pen.globalAlpha = 1;
}
function paint(taken) {
  const { piece, lines } = taken, style = data.looks[piece.look], tone = (share) => mixed(style.color, piece.color, share);
  if (piece.radius) paintBall(taken, style, tone);
  else if (piece.hint) for (const line of lines) { way(line); rule(tone(1), style.fine, 1); }
  else {
    paintFaces(taken, style, tone);
    for (const line of lines) { way(line); rule(tone(0.6), style.fine, 1); }
    paintEdges(taken, style, tone);
  }
}
function paintFlat({ stroke, points, isArea }) {
  const style = data.styles[stroke.style], tone = (name) => color(name, stroke.owner);
  if (style.fill && isArea) fill(points, tone(style.fill), style.alpha);
  if (!style.stroke) return;
  way(points, isArea);
  rule(tone(style.stroke), style.width, 1, style.dashes);
}
function paintBall({ points, lines, radius }, style, tone) {
  const middle = points[0], outline = disc(middle, radius, 48);
  fill(outline, tone(style.tint), style.cover);
  if (style.shade) {
    const lit = disc([middle[0] + 0.18 * radius * data.light[0], middle[1] + 0.18 * radius * data.light[1]], 0.88 * radius, 48);
    fill(shown.isDark() ? lit : [...outline, outline[0], lit[0], ...lit.reverse()], tone(1), 0.35 * style.shade);
  }
  for (const line of lines) {
    for (let k = 0; k < line.length - 1;) {
      const isNear = line[k][2] > middle[2], run = [line[k]];
      while (++k < line.length && run.push(line[k]) && (line[k][2] > middle[2]) === isNear);
      way(run);
      rule(tone(1), style.fine, isNear ? 1 : style.hidden, isNear ? [] : data.dashes);
    }
  }
  way(outline, true);
  rule(tone(1), style.width, 1);
}
function paintFaces({ piece, points, normals, outline }, style, tone) {
  if (piece.smooth) {
    fill(outline, tone(style.tint), style.cover);
    if (style.is_seamed) rule(tone(style.tint), 0.6, 1);
  }
  piece.faces.forEach((face, k) => {
    if (normals[k][2] <= 0 || piece.open.includes(k)) return;
    // on dark paper what the light meets has more colour
    const lit = Math.max(0, dot(unit(normals[k]), data.light)), corners = face.map((i) => points[i]);
    const more = style.shade * (shown.isDark() ? lit : 1 - lit);
    if (piece.smooth) { if (more > 0.01) fill(corners, tone(1), more * style.cover); return; }
    const paper = tone(style.tint + more * (1 - style.tint));
    fill(corners, paper, style.cover);
    if (style.is_seamed) rule(paper, 0.6, 1);
  });
}
function paintEdges({ piece, points, normals }, style, tone) {
  if (!style.width) return;
  const isFront = (k) => normals[k][2] > 0, kinds = { hidden: [], seen: [], marks: [] };
  for (const [a, b, left, right, kind] of piece.edges) {
    const n = isFront(left) + isFront(right);
    if (kind === 1) { if (n) kinds.marks.push([a, b]); }
    else if (n && (kind === 2 || n === 1)) kinds.seen.push([a, b]);
    else if (kind === 2 && !n && style.hidden) kinds.hidden.push([a, b]);
  }
  const trace = (edges) => {
    let end = -1;
    pen.beginPath();
    for (const [a, b] of edges) {
      if (a !== end) pen.moveTo(...onPaper(points[a]));
      pen.lineTo(...onPaper(points[b]));
      end = b;
    }
  };
  if (kinds.hidden.length) { trace(kinds.hidden); rule(tone(1), style.fine, style.hidden, data.dashes); }
  if (kinds.marks.length) { trace(kinds.marks); rule(tone(1), style.fine, 0.8); }
  if (kinds.seen.length) { trace(kinds.seen); rule(tone(1), style.width, 1); }
}
function measure() {
  const box = canvas.getBoundingClientRect(), ratio = devicePixelRatio || 1;
  canvas.width = Math.round(box.width * ratio);
  canvas.height = Math.round(box.height * ratio);
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  view = { width: box.width, height: box.height };
  draw();
}
function fit() {
  // arrows over the motion stand out of it
  const more = shown.overlays?.()?.found.arrows.length ? Math.min(0.6 * LONGEST, 0.12 * view.height) : 0, [edge, ground] = data.planar ? [8, 82] : [34, 96];
  const [x0, y0, x1, y1] = data.bounds, room = edge + more, foot = ground + more, head = Math.max(edge, shown.head ?? 0) + more;
  view.scale = camera.zoom * Math.min((view.width - 2 * room) / (x1 - x0), (view.height - head - foot) / (y1 - y0));
  // the middle of the picture as it is at first
  view.x = view.width / 2 - view.scale * (x0 + x1) / 2 + camera.shift[0];
  view.y = (view.height - foot + head) / 2 + view.scale * (y0 + y1) / 2 + camera.shift[1];
}
function draw() {
  if (!view) return;
  known = { frame: at, poses: [] };
  fit();
  pen.clearRect(0, 0, view.width, view.height);
  pen.lineCap = pen.lineJoin = "round";
  const n_bodies = n_moving + data.fixed.length, poses = Array.from({ length: n_bodies }, (_, body) => pose(body, at));
  const all = data.pieces.map((piece) => shot(piece, poses)), flats = all.filter((s) => s.piece.look === "plane");
  const solids = backToFront(all.filter((s) => s.piece.look !== "plane"));
  const frame = Math.floor(at + 1e-9), isOn = (mark) => mark.frames.filter((k) => k <= frame).length % 2 === 1;
  const strokes = [...data.strokes, ...data.marks.filter(isOn)].map((stroke) => flat(stroke, at));
  flats.filter((s) => s.normals[0][2] > 0).forEach(paint);
  for (const k of shown.traced) if (data.points[k]) traceOf(data.points[k]);
  if (shown.hasGhosts?.()) ghosts();
  strokes.forEach(paintFlat);
  solids.forEach(paint);
  flats.filter((s) => s.normals[0][2] <= 0).forEach(paint);
  taken = [...strokes, ...solids];
  taken.filter((s) => shown.selected.has(s.owner)).forEach(outlined);
  pen.setLineDash([]);
  pen.font = "13px system-ui, sans-serif";
  pen.textBaseline = "middle";
  const over = shown.overlays?.();
  valued = [];
  if (over) overlaid(over);
  if (shown.hasNames()) { labels([...strokes, ...solids]); data.words.forEach(wordBeside); }
  corner();
  shown.drawn(at, data.t0 + at * data.dt);
}
const N_GHOSTS = 8, VEIL = 0.22;
function ghosts() {
  // the moving bodies at times that are equally far from each other, faintly
  const moves = (owner) => owner >= 0 && owner < n_moving, before = known;
  const strokes = data.strokes.filter((stroke) => stroke.shape === "path" && moves(stroke.place[0])), pieces = data.pieces.filter((piece) => moves(piece.turn));
  veil = VEIL;
  for (let k = 0; k <= N_GHOSTS; k++) {
    const frame = k * last / N_GHOSTS;
    known = { frame, poses: [] };
    const poses = Array.from({ length: n_moving + data.fixed.length }, (_, body) => pose(body, frame));
    strokes.map((stroke) => flat(stroke, frame)).forEach(paintFlat);
    backToFront(pieces.map((piece) => shot(piece, poses))).forEach(paint);
  }
  veil = 1;
  known = before;
}
function outlined({ outline, isArea, points }) {
  way(isArea ? outline : points, isArea);
  rule(theme().measure, 2.4, 1);
}
function traceOf(point) {
  const track = [];
  for (let i = 0; i <= Math.floor(at); i++) track.push(seen(position(point.place, i)));
  track.push(seen(position(point.place, at)));
  way(track);
  rule(color("body", point.color), 1.4, 1);
}

// -- over the motion: arrows, centres and friction cones, as long over all of it as the largest says
let valued = []; // what is written there, which names keep clear of
const LONGEST = 90, LEAST = 5, CONE = 80, UNITS = { velocity: "m/s", acceleration: "m/s^2", force: "N", couple: "N m" };
function overlaid({ found, isStale }) {
  const time = data.t0 + at * data.dt, inks = { velocity: "velocity", acceleration: "acceleration", reaction: "reaction", load: "force" };
  pen.globalAlpha = isStale ? 0.3 : 1;
  for (const cone of found.cones) coneOf(cone, time);
  const centres = [];
  for (const spot of found.spots) {
    const p = footOf(spot, time);
    if (p && spot.kind === "mass-centres") massCentre(p, spot.label ? 6 : 9);
    else if (p) { instantCentre(p); centres.push([p, spot.label]); }
  }
  if (shown.hasNames()) for (const [p, label] of centres) nameOfCentre(p, label);
  for (const each of found.arrows) {
    const p = footOf(each, time), v = sampled(each.vector, each.times, time);
    if (!p || !v) continue;
    const size = Math.hypot(...v), scale = each.is_couple ? "couple" : UNITS[each.kind] ? each.kind : "force", { largest, by_root } = found.scales[scale];
    const paint = theme()[inks[each.kind]], share = size / largest, long = LONGEST * (by_root ? Math.sqrt(share) : share);
    const way = onSheet(v).map((c) => c / (size || 1) * long), l = Math.hypot(...way);
    if (!(size > (by_root ? 1e-4 : 1e-3) * largest)) continue;
    const turns = each.is_couple && data.planar, tip = turns ? turnOf(p, Math.sign(v[2]), paint) : [p[0] + way[0], p[1] + way[1]];
    if (!turns && l < 1) continue; // it points at the viewer
    if (shown.lit?.(each)) { pen.beginPath(); pen.moveTo(...p); pen.lineTo(...tip); pen.strokeStyle = theme().measure; pen.lineWidth = 6; pen.stroke(); }
    if (!turns) arrow(p, way, paint);
    if (!turns && each.is_couple) arrow(p, way.map((c) => c * Math.max(0, 1 - 8 / l)), paint); // a moment has two heads
    if (!shown.hasNames() || (!turns && l < LEAST)) continue;
    const letter = { velocity: "v", acceleration: "a" }[each.kind] ?? each.label, text = letter + " = " + shown.quantity(size, UNITS[scale]);
    pen.textAlign = way[0] < -0.3 * l ? "right" : way[0] > 0.3 * l ? "left" : "center";
    const spot = [tip[0] + 6 * way[0] / (l || 1), tip[1] + 11 * way[1] / (l || 1)]; // within the picture
    const w = widthOf(text), before = { left: 0, right: w, center: w / 2 }[pen.textAlign];
    const [x, y] = [Math.max(before, Math.min(view.width - w + before, spot[0])), Math.max(9, Math.min(view.height - 9, spot[1]))];
    spell(text, [x - before, y], paint);
    valued.push({ spot: [x - before + w / 2, y], half: [w / 2, 8] });
  }
  pen.globalAlpha = 1;
}
function sampled(columns, times, time) {
  // between two times; nothing where there is nothing at one of them
  let low = 0, high = times.length - 1;
  while (high - low > 1) { const middle = (low + high) >> 1; if (times[middle] <= time) low = middle; else high = middle; }
  const s = high > low ? Math.max(0, Math.min(1, (time - times[low]) / (times[high] - times[low]))) : 0;
  const found = columns.map((c) => {
    const [a, b] = c.length === 1 ? [c[0], c[0]] : [c[low], c[high]];
    return s < 1e-9 ? a : s > 1 - 1e-9 ? b : a === null || b === null ? null : a + s * (b - a);
  });
  return found.includes(null) ? null : found;
}
function footOf(each, time) {
  // nothing where it is of a model before this one, with other bodies or fewer axes
  const place = sampled(each.at, each.times, time), body = data.names.indexOf(each.body);
  if (!place || (each.body ? body < 0 : !data.planar && place.length < 3)) return null;
  return onPaper(seen(each.body ? position([body, ...place], at) : place));
}
const onSheet = (v) => [dot(camera.axes[0], v), -dot(camera.axes[1], v)];
function turnOf([x, y], sense, paint) {
  // a couple about z, counter-clockwise where it is positive; gives where its name stands
  const r = 22, from = sense > 0 ? 0.5 : Math.PI - 0.5, to = from + sense * 4.2, tip = [x + r * Math.cos(to), y - r * Math.sin(to)];
  pen.beginPath();
  pen.arc(x, y, r, -from, -to, sense > 0);
  pen.strokeStyle = paint;
  pen.lineWidth = 1.5;
  pen.stroke();
  const along = [-sense * Math.sin(to), -sense * Math.cos(to)];
  arrow([tip[0] - 9 * along[0], tip[1] - 9 * along[1]], along.map((c) => 9 * c), paint);
  return [x, y - r - 10];
}
function massCentre([x, y], r) {
  pen.lineWidth = 1.4;
  pen.strokeStyle = pen.fillStyle = theme().ink;
  for (const [from, isFilled] of [[0, 1], [0.5, 0], [1, 1], [1.5, 0]]) {
    pen.beginPath();
    pen.moveTo(x, y);
    pen.arc(x, y, r, from * Math.PI, (from + 0.5) * Math.PI);
    pen.fillStyle = isFilled ? theme().ink : theme().paper;
    pen.fill();
  }
  pen.beginPath();
  pen.arc(x, y, r, 0, 2 * Math.PI);
  pen.stroke();
}
function instantCentre([x, y]) {
  pen.beginPath();
  for (const s of [-1, 1]) { pen.moveTo(x - 6, y - 6 * s); pen.lineTo(x + 6, y + 6 * s); }
  pen.strokeStyle = theme().acceleration;
  pen.lineWidth = 2;
  pen.stroke();
  valued.push({ spot: [x, y], half: [6, 6] });
}
function nameOfCentre([x, y], label) {
  // at one of its corners, or farther up or down: where the least lies below it
  const half = [pen.measureText(label).width / 2 + 2, 8];
  const places = [0, 16, 32].flatMap((far) => [[1, -1], [-1, -1], [1, 1], [-1, 1]].map(([right, down]) => [x + right * (8 + half[0]), y + down * (9 + far)]));
  const isOut = ([u, v]) => u < half[0] || u > view.width - half[0] || v < half[1] + (shown.head ?? 0) || v > view.height - half[1];
  const costs = places.map((spot) => valued.filter((other) => areOver(other, { spot, half })).length + 4 * isOut(spot));
  const spot = places[costs.indexOf(Math.min(...costs))];
  pen.textAlign = "center";
  write(label, spot, theme().acceleration);
  valued.push({ spot, half });
}
function coneOf(cone, time) {
  const p = footOf(cone, time), axis = sampled(cone.axis, cone.times, time), used = sampled([cone.used], cone.times, time);
  if (!p || !axis) return;
  const side = (a) => {
    const [c, s] = [Math.cos(a), Math.sin(a)], [dx, dy] = onSheet([c * axis[0] - s * axis[1], s * axis[0] + c * axis[1], 0]);
    return [p[0] + CONE / c * dx, p[1] + CONE / c * dy];
  };
  const part = (from, to, alpha) => {
    const before = pen.globalAlpha;
    pen.beginPath();
    for (const q of [p, side(from), side(to)]) pen.lineTo(...q);
    pen.closePath();
    pen.globalAlpha = alpha * before;
    pen.fillStyle = theme().reaction;
    pen.fill();
    pen.globalAlpha = before;
  };
  part(-cone.half, cone.half, 0.12);
  if (used) part(0, used[0], 0.3); // nothing where it is not unique
  pen.beginPath();
  for (const a of [-cone.half, cone.half]) { pen.moveTo(...p); pen.lineTo(...side(a)); }
  pen.strokeStyle = theme().reaction;
  pen.lineWidth = 1;
  pen.stroke();
}

// -- names beside their bodies: each keeps its side until another one is clearly better
const sides = new Map();
let drawn = 0;
function boxOf(points) {
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) {
    if (x < box[0]) box[0] = x;
    if (y < box[1]) box[1] = y;
    if (x > box[2]) box[2] = x;
    if (y > box[3]) box[3] = y;
  }
  return box;
}
function inkOf({ owner, outline, isArea }) {
  // what is drawn of a shape, as spots along its outline that stand at most 5 pixels apart
  const line = outline.map(onPaper), spots = [];
  line.forEach((p, k) => {
    if (!isArea && k === line.length - 1) return;
    const q = line[(k + 1) % line.length], n = Math.min(60, Math.ceil(Math.hypot(q[0] - p[0], q[1] - p[1]) / 5));
    for (let i = 0; i < n; i++) spots.push([p[0] + i / n * (q[0] - p[0]), p[1] + i / n * (q[1] - p[1])]);
  });
  return { owner, isArea, outline: line, spots, box: boxOf(line) };
}
// a name takes the place round a spot, half as wide and high as `half` says; shapes too far away are told by their boxes
const away = (box, spot, half, c) => Math.max(0, box[c] - spot[c] - half[c], spot[c] - box[c + 2] - half[c]);
const isIn = (box, [x, y]) => x >= box[0] && y >= box[1] && x <= box[2] && y <= box[3];
function nCovered(ink, spot, half, more) {
  let n = 0;
  for (const { box, spots } of ink) {
    if (away(box, spot, half, 0) > more || away(box, spot, half, 1) > more) continue;
    for (const p of spots) n += Math.abs(p[0] - spot[0]) < half[0] + more && Math.abs(p[1] - spot[1]) < half[1] + more;
  }
  return n;
}
function gapTo(ink, spot, half) {
  let least = 1e18; // its square
  for (const { box, spots } of ink) {
    if (away(box, spot, half, 0) ** 2 + away(box, spot, half, 1) ** 2 >= least) continue;
    for (const p of spots) {
      const dx = Math.max(0, Math.abs(p[0] - spot[0]) - half[0]), dy = Math.max(0, Math.abs(p[1] - spot[1]) - half[1]);
      least = Math.min(least, dx * dx + dy * dy);
    }
  }
  return Math.sqrt(least);
}
function spotBeside(own, middle, half, k) {
  // just outside of the body in a direction from its middle, or its middle
  if (k === 12) return middle;
  const a = Math.PI / 4 + 2 * Math.PI * k / 12, e = [Math.cos(a), -Math.sin(a)];
  let far = -Infinity, spot = middle;
  for (const { spots } of own) for (const p of spots) far = Math.max(far, (p[0] - middle[0]) * e[0] + (p[1] - middle[1]) * e[1]);
  for (let s = far + Math.abs(e[0]) * half[0] + Math.abs(e[1]) * half[1] + 5; s > 0; s -= 3) {
    const next = [middle[0] + s * e[0], middle[1] + s * e[1]];
    if (nCovered(own, next, half, 3)) break;
    spot = next;
  }
  return spot;
}
const areOver = (a, b) => Math.abs(a.spot[0] - b.spot[0]) < a.half[0] + b.half[0] && Math.abs(a.spot[1] - b.spot[1]) < a.half[1] + b.half[1];
const N_WAYS = 13, FARTHER = 16, N_RINGS = 9, TOO_MUCH = 6;
function labels(all) {
  const isDue = drawn++ % 12 === 0 || !shown.isPlaying(), placed = [...data.words.map(boxOfWord), ...valued], ink = all.map(inkOf);
  const names = [];
  for (const { owner, text } of data.labels) {
    const own = ink.filter((each) => each.owner === owner && each.spots.length), others = ink.filter((each) => each.owner !== owner);
    if (!own.length) continue;
    const half = [pen.measureText(text).width / 2 + 2, 8], [x0, y0, x1, y1] = boxOf(own.flatMap((each) => each.spots));
    const middle = [(x0 + x1) / 2, (y0 + y1) / 2], near = [];
    // a place is a direction, and how many steps farther away than just outside
    const spotAt = (place) => {
      const k = place % N_WAYS, far = FARTHER * Math.floor(place / N_WAYS), a = Math.PI / 4 + 2 * Math.PI * k / 12;
      const [x, y] = (near[k] ??= spotBeside(own, middle, half, k));
      return [x + far * Math.cos(a), y - far * Math.sin(a)];
    };
    const isFree = (spot) => !placed.some((other) => areOver(other, { spot, half }));
    const cost = (spot, place) => {
      const isOut = spot[0] < half[0] || spot[0] > view.width - half[0] || spot[1] < half[1] + (shown.head ?? 0) || spot[1] > view.height - 60;
      const isOnOthers = others.some((s) => s.isArea && isIn(s.box, spot) && contains(s.outline, spot));
      const gap = gapTo(own, spot, half), below = nCovered(ink, spot, half, 0);
      return 100 * isOut + 0.8 * below + 3 * isOnOthers + 4 * Math.min(1, Math.max(0, 0.5 + (gap - gapTo(others, spot, half)) / 26))
        + 0.06 * gap + 0.005 * Math.hypot(spot[0] - middle[0], spot[1] - middle[1]) + Math.floor(place / N_WAYS) - (sides.get(owner) === place ? 2 : 0);
    };
    if (isDue || !sides.has(owner) || !isFree(spotAt(sides.get(owner)))) {
      let best = Infinity, side;
      const look = (place) => {
        const spot = spotAt(place), c = isFree(spot) ? cost(spot, place) : Infinity;
        if (c < best) [best, side] = [c, place];
      };
      // farther away only where what is free nearer covers much
      for (let ring = 0; ring < N_RINGS && best >= TOO_MUCH + ring; ring++) for (let k = 0; k < N_WAYS - (ring > 0); k++) look(ring * N_WAYS + k);
      if (sides.has(owner)) look(sides.get(owner));
      if (side === undefined) { sides.delete(owner); continue; }
      sides.set(owner, side);
    }
    const place = sides.get(owner), name = { spot: spotAt(place), half, text };
    placed.push(name);
    names.push(name);
    if (place >= N_WAYS) leader(own, name);
  }
  pen.textAlign = "center";
  for (const { spot, text } of names) write(text, spot, theme().ink);
}
function leader(own, { spot, half }) {
  // from a name that stands away from its body to the nearest place of it
  let least = Infinity, end = spot;
  for (const { spots } of own) for (const p of spots) { const d = Math.hypot(p[0] - spot[0], p[1] - spot[1]); if (d < least) { least = d; end = p; } }
  const way = [end[0] - spot[0], end[1] - spot[1]], from = Math.min(1, ...way.map((c, k) => half[k] / Math.abs(c || 1e-9)));
  pen.beginPath();
  pen.moveTo(spot[0] + from * way[0], spot[1] + from * way[1]);
  pen.lineTo(...end);
  pen.strokeStyle = theme().muted;
  pen.lineWidth = 0.8;
  pen.stroke();
}
function boxOfWord({ place, text, dx, dy }) {
  const [x, y] = onPaper(seen(position(place, at))), u = data.symbol * view.scale, width = pen.measureText(text).width;
  return { spot: [Math.max(2, Math.min(x + dx * u, view.width - width - 2)) + width / 2, y - dy * u], half: [width / 2, 8], text };
}
function wordBeside(word) {
  const { spot, text } = boxOfWord(word);
  pen.textAlign = "center";
  write(text, spot, theme().ink);
}
function contains(outline, [x, y]) {
  // on paper y runs down, so the outline is clockwise
  return outline.every((p, k) => { const q = outline[(k + 1) % outline.length]; return (q[0] - p[0]) * (y - p[1]) <= (q[1] - p[1]) * (x - p[0]); });
}
function write(text, [x, y], paint) {
  pen.lineWidth = 3;
  pen.strokeStyle = theme().paper;
  pen.fillStyle = paint;
  pen.strokeText(text, x, y);
  pen.fillText(text, x, y);
}
const INDEX = 0.75; // how large an index is beside its letter
/** A text in runs: those behind a low line stand below, as in T_rod1 = 5 N. */
function runsOf(text) {
  const plain = pen.font, small = plain.replace(/[\d.]+px/, (size) => INDEX * parseFloat(size) + "px");
  return text.split(/_(\w+)/).map((part, k) => ({ part, font: k % 2 ? small : plain, down: k % 2 ? 4 : 0 }));
}
function eachRun(text, work) {
  const before = pen.font;
  for (const run of runsOf(text)) { pen.font = run.font; work(run, pen.measureText(run.part).width); }
  pen.font = before;
}
function widthOf(text) {
  let width = 0;
  eachRun(text, (_run, own) => { width += own; });
  return width;
}
function spell(text, [left, y], paint) {
  // first the paper behind all of it
  pen.textAlign = "left";
  pen.lineWidth = 3;
  pen.strokeStyle = theme().paper;
  pen.fillStyle = paint;
  for (const draw of ["strokeText", "fillText"]) {
    let x = left;
    eachRun(text, ({ part, down }, own) => { pen[draw](part, x, y + down); x += own; });
  }
}
function corner() {
  // the axes of the ground with their length, and the direction of gravity
  const x = data.planar ? 24 : 58, y = view.height - (data.planar ? 18 : 60), ink = theme().ink;
  const most = (data.planar ? 64 : 42) / view.scale;
  let length = 10 ** Math.floor(Math.log10(most));
  for (const m of [5, 2]) if (length * m <= most) { length *= m; break; }
  const size = length * view.scale, right = Math.max(66, size + 26);
  pen.textAlign = "center";
  const axes = data.planar ? [0, 1] : [0, 1, 2].sort((a, b) => camera.axes[2][a] - camera.axes[2][b]);
  for (const k of axes) {
    const along = [camera.axes[0][k], -camera.axes[1][k]], l = Math.hypot(...along);
    arrow([x, y], along.map((c) => size * c), theme().muted);
    const away = l * size > 4 ? along.map((c) => c / l) : [-0.7, 0.7];
    write("xyz"[k], [x + size * along[0] + 10 * away[0], y + size * along[1] + 10 * away[1]], ink);
  }
  if (data.planar) {
    // angles are positive counter-clockwise
    const r = 0.6 * size, a = 1.15, tip = [x + r * Math.cos(a), y - r * Math.sin(a)];
    pen.beginPath();
    pen.arc(x, y, r, 0, 0.3 - a, true);
    pen.strokeStyle = theme().muted;
    pen.lineWidth = 1.2;
    pen.stroke();
    arrow([tip[0] + 9 * Math.sin(a), tip[1] + 9 * Math.cos(a)], [-9 * Math.sin(a), -9 * Math.cos(a)], theme().muted);
    write("+", [x + r + 7, y - 0.6 * r], ink);
  }
  pen.textAlign = "left";
  const told = data.has_lengths ? shown.axes(Number(length.toPrecision(1))) : "";
  write(told, [x + right, y + 8], theme().muted);
  const beside = x + right + Math.max(130, pen.measureText(told).width + 18);
  if (data.gravity) {
    const down = [dot(camera.axes[0], data.gravity), -dot(camera.axes[1], data.gravity)];
    arrow([beside, y - 20], down.map((c) => 38 * c), theme().force);
    write("g", [beside + 8, y - 4], ink);
  }
}
function arrow([x, y], [dx, dy], paint) {
  const l = Math.hypot(dx, dy), e = [dx / (l || 1), dy / (l || 1)], s = Math.min(8, l / 2);
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(x + dx - 0.8 * s * e[0], y + dy - 0.8 * s * e[1]);
  pen.strokeStyle = pen.fillStyle = paint;
  pen.lineWidth = 1.5;
  pen.stroke();
  if (l < 3) return;
  pen.beginPath();
  pen.moveTo(x + dx, y + dy);
  pen.lineTo(x + dx - s * (e[0] - 0.4 * e[1]), y + dy - s * (e[1] + 0.4 * e[0]));
  pen.lineTo(x + dx - s * (e[0] + 0.4 * e[1]), y + dy - s * (e[1] - 0.4 * e[0]));
  pen.fill();
}

// -- turning and moving the view
function turn(azimuth, elevation) { look(camera.azimuth + azimuth, camera.elevation + elevation); draw(); }
function zoom(factor) {
  const before = camera.zoom;
  camera.zoom = Math.max(0.2, Math.min(20, before * factor));
  camera.shift = camera.shift.map((c) => c * camera.zoom / before);
  draw();
}
function pan(right, down) { camera.shift = [camera.shift[0] + right, camera.shift[1] + down]; draw(); }
function resetView() { Object.assign(camera, { zoom: 1, shift: [0, 0] }); look(...data.angles); draw(); }
function move(right, down) { if (data.planar) pan(right, down); else turn(-0.4 * right, 0.4 * down); }
const fingers = new Map();
const spread = () => { const [a, b] = [...fingers.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]); };
canvas.style.touchAction = "none";
canvas.style.cursor = "grab";
canvas.addEventListener("pointerdown", (event) => {
  if (event.defaultPrevented) return;
  fingers.set(event.pointerId, [event.clientX, event.clientY]);
  canvas.setPointerCapture(event.pointerId);
});
canvas.addEventListener("pointermove", (event) => {
  const start = fingers.get(event.pointerId);
  if (!start) return;
  const before = fingers.size === 2 ? spread() : 0;
  fingers.set(event.pointerId, [event.clientX, event.clientY]);
  if (before) zoom(spread() / before);
  else if (fingers.size === 1) move(event.clientX - start[0], event.clientY - start[1]);
});
for (const kind of ["pointerup", "pointercancel"]) canvas.addEventListener(kind, (event) => fingers.delete(event.pointerId));
canvas.addEventListener("wheel", (event) => { event.preventDefault(); zoom(Math.exp(-0.0015 * event.deltaY)); }, { passive: false });
canvas.addEventListener("dblclick", resetView);

// -- for the page around it
function show(fresh, frame = at) {
  // another motion at a frame of it, in the same view, as far as it is of the same kind; what is held by the pointer
  // stays under it, whatever the new motion needs of room
  const isKept = data.planar === fresh.planar, { bounds, middle, distance } = data;
  data = isKept && shown.isHeld?.() ? { ...fresh, bounds, middle, distance } : fresh;
  [last, n_moving, stride] = [data.n_frames - 1, data.names.length, data.planar ? 3 : 7];
  at = Math.max(0, Math.min(last, frame));
  begun = null;
  if (isKept) draw(); else resetView();
}
function begin(columns) {
  // the picture of the start with these columns, one number each, before its motion is there
  [begun, at] = [columns, 0];
  draw();
}
function go(frame) { at = Math.max(0, Math.min(last, frame)); draw(); }
function pick([x, y]) {
  // the label of what lies at a place on the canvas, the frontmost first
  const isNear = (p, q) => {
    const [dx, dy] = [q[0] - p[0], q[1] - p[1]], l = dx * dx + dy * dy;
    const s = l ? Math.max(0, Math.min(1, ((x - p[0]) * dx + (y - p[1]) * dy) / l)) : 0;
    return Math.hypot(p[0] + s * dx - x, p[1] + s * dy - y) < 7;
  };
  for (let k = taken.length - 1; k >= 0; k--) {
    if (!data.labels.some((label) => label.owner === taken[k].owner)) continue;
    const line = taken[k].outline.map(onPaper);
    if (line.some((p, i) => i > 0 && isNear(line[i - 1], p)) || (taken[k].isArea && line.length > 2 && contains(line, [x, y]))) return taken[k].owner;
  }
  return null;
}
const onSight = ([x, y]) => [(x - view.x) / view.scale, (view.y - y) / view.scale];
function place(spot, depth = 0) {
  // where in the model a place on the canvas is, so deep in the picture: `seen` undone
  const local = [...onSight(spot), depth], shrunk = data.distance ? data.distance / (data.distance + depth) : 1;
  return [0, 1, 2].map((c) => data.middle[c] + shrunk * local.reduce((sum, l, k) => sum + l * camera.axes[k][c], 0));
}
function depth(spot) {
  // of what `pick` finds there
  const owner = pick(spot), solids = taken.filter((each) => each.owner === owner && each.piece);
  const hit = solids.findLast((each) => contains(each.outline.map(onPaper), spot));
  return hit ? depths(hit, onSight(spot))[1] : solids.at(-1)?.depth ?? 0;
}
function held(name) {
  // by what a body is moved without a pointer: its mass centre, then what is drawn farthest from that; each with its depth
  const own = taken.filter((each) => each.owner === data.labels.find((label) => label.text === name)?.owner);
  const center = seen(pose(data.names.indexOf(name), at)[0]), away = (p) => Math.hypot(p[0] - center[0], p[1] - center[1]);
  const far = own.flatMap((each) => each.points).reduce((most, p) => (away(p) > away(most) ? p : most), center);
  return [center, far].map((p) => ({ spot: onPaper(p), depth: p[2] }));
}
resetView();
return { draw, measure, show, begin, go, turn, zoom, move, resetView, pick, place, depth, held, sides: () => camera.axes.slice(0, 2), at: () => at, last: () => last };
}
