// -- places at a frame, which may lie between two
function column(k, f) {
  const track = data.columns[k], i = Math.min(Math.floor(f), last), j = Math.min(i + 1, last);
  return track[i] + (f - i) * (track[j] - track[i]);
}
function angle(body, f) { return body < 0 ? 0 : column(3 * body + 2, f); }
function position([body, x, y], f) {
  if (body < 0) return [x, y];
  const c = Math.cos(angle(body, f)), s = Math.sin(angle(body, f));
  return [column(3 * body, f) + c * x - s * y, column(3 * body + 1, f) + s * x + c * y];
}

// -- strokes as lists of ground points
const shapes = {
  path(stroke, f) {
    const [x, y] = position(stroke.place, f), a = angle(stroke.turn, f), c = Math.cos(a), s = Math.sin(a);
    return stroke.points.map(([u, v]) => [x + c * u - s * v, y + s * u + c * v]);
  },
  stretch(stroke, f) {
    const a = position(stroke.first, f), b = position(stroke.second, f), dx = b[0] - a[0], dy = b[1] - a[1];
    const l = Math.hypot(dx, dy) || 1;
    return stroke.points.map(([u, v]) => [a[0] + u * dx - v * dy / l, a[1] + u * dy + v * dx / l]);
  },
  strand(stroke, f) {
    const n = stroke.n_leads, lead = (k) => column(3 * data.names.length + stroke.lead + k, f), points = [];
    stroke.nodes.forEach(([body, x, y, arm, drum], k) => {
      const before = k > 0 ? lead(k - 1) : stroke.closed ? lead(n - 1) : null;
      const after = k < n ? lead(k) : stroke.closed ? lead(0) : null;
      const sense = Math.sign(arm), wound = drum ? sense * 1.5 * Math.PI : 0;
      const into = before !== null ? before : after - wound, out = after !== null ? after : before + wound;
      let turn = ((sense * (out - into)) % (2 * Math.PI) + 2 * Math.PI) % (2 * Math.PI);
      turn = drum ? wound : turn > 1.8 * Math.PI ? 0 : sense * turn;
      const parts = arm ? Math.max(1, Math.ceil(Math.abs(turn) / 0.1)) : 0;
      const [cx, cy] = position([body, x, y], f);
      for (let i = 0; i <= parts; i++) {
        const a = into + (parts ? turn * i / parts : 0);
        points.push([cx + arm * Math.sin(a), cy - arm * Math.cos(a)]);
      }
    });
    return points;
  },
};

// -- drawing
function color(name, body) { const t = theme(); return name === "body" ? t.bodies[body % t.bodies.length] : t[name]; }
function theme() { return data.themes[darkPaper.matches ? "dark" : "light"]; }
function line(points) {
  pen.beginPath();
  for (const [x, y] of points) pen.lineTo(view.x + view.scale * x, view.y - view.scale * y);
}
function measure() {
  const box = canvas.getBoundingClientRect(), ratio = devicePixelRatio || 1, strip = 58;
  canvas.width = Math.round(box.width * ratio);
  canvas.height = Math.round(box.height * ratio);
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  const [x0, y0, x1, y1] = data.view, h = box.height - strip;
  const scale = Math.min(box.width / (x1 - x0), h / (y1 - y0));
  view = { scale, x: box.width / 2 - scale * (x0 + x1) / 2, y: h / 2 + scale * (y0 + y1) / 2, width: box.width, height: box.height };
  draw();
}
function draw() {
  if (!view) return;
  pen.clearRect(0, 0, view.width, view.height);
  pen.lineCap = pen.lineJoin = "round";
  for (const k of traced) trace(data.points[k], k);
  const frame = Math.floor(at + 1e-9);
  const isOn = (mark) => mark.frames.filter((k) => k <= frame).length % 2 === 1;
  for (const stroke of [...data.strokes, ...data.marks.filter(isOn)]) {
    const style = data.styles[stroke.style];
    line(shapes[stroke.shape](stroke, at));
    if (stroke.closed && stroke.shape !== "strand") pen.closePath();
    if (style.fill) {
      pen.globalAlpha = style.alpha;
      pen.fillStyle = color(style.fill, stroke.color);
      pen.fill();
      pen.globalAlpha = 1;
    }
    if (!style.stroke) continue;
    pen.setLineDash(style.dashes);
    pen.lineWidth = 1.25 * style.width;
    pen.strokeStyle = color(style.stroke, stroke.color);
    pen.stroke();
  }
  pen.setLineDash([]);
  pen.font = "13px system-ui, sans-serif";
  pen.textBaseline = "middle";
  if (byId("names").checked) for (const label of data.labels) name(label);
  legend();
  const t = data.t0 + at * data.dt;
  byId("time").textContent = "t = " + t.toFixed(3) + " s";
  byId("scrub").value = Math.round(at);
  byId("scrub").setAttribute("aria-valuetext", t.toFixed(2) + " seconds");
}
function name({ place, text, dx, dy }) {
  const [x, y] = position(place, at), u = data.symbol * view.scale;
  const width = pen.measureText(text).width, px = view.x + view.scale * x + dx * u - (dx < 0 ? width : 0);
  const py = view.y - view.scale * y - dy * u;
  pen.textAlign = "left";
  pen.lineWidth = 3;
  pen.strokeStyle = theme().paper;
  pen.fillStyle = theme().ink;
  const x0 = Math.max(2, Math.min(px, view.width - width - 2));
  pen.strokeText(text, x0, py);
  pen.fillText(text, x0, py);
}
function trace(point, k) {
  const way = [];
  for (let i = 0; i <= Math.floor(at); i++) way.push(position(point.place, i));
  way.push(position(point.place, at));
  line(way);
  pen.setLineDash([]);
  pen.lineWidth = 1.6;
  pen.strokeStyle = theme().bodies[point.color % theme().bodies.length];
  pen.stroke();
}
function legend() {
  // a bar of a round length, and the axes: x right, y up, angles counter-clockwise
  const base = view.height - 20, ink = theme().muted;
  let length = 10 ** Math.floor(Math.log10(150 / view.scale));
  for (const m of [5, 2]) if (length * m * view.scale <= 150) { length *= m; break; }
  pen.strokeStyle = pen.fillStyle = ink;
  pen.lineWidth = 1.5;
  pen.textAlign = "left";
  pen.beginPath();
  for (const [x, y] of [[20, base - 5], [20, base], [20 + length * view.scale, base], [20 + length * view.scale, base - 5]]) pen.lineTo(x, y);
  pen.stroke();
  pen.fillText(Number(length.toPrecision(1)) + " m", 22, base - 15);
  const ox = view.width - 76, a = 34;
  pen.beginPath();
  pen.moveTo(ox, base - a); pen.lineTo(ox, base); pen.lineTo(ox + a, base);
  pen.moveTo(ox - 4, base - a + 7); pen.lineTo(ox, base - a); pen.lineTo(ox + 4, base - a + 7);
  pen.moveTo(ox + a - 7, base - 4); pen.lineTo(ox + a, base); pen.lineTo(ox + a - 7, base + 4);
  pen.moveTo(ox + 20, base); pen.arc(ox, base, 20, 0, -1.15, true);
  const ex = ox + 20 * Math.cos(1.15), ey = base - 20 * Math.sin(1.15);
  pen.moveTo(ex + 7, ey - 1); pen.lineTo(ex, ey); pen.lineTo(ex + 3, ey + 7);
  pen.stroke();
  pen.fillText("x", ox + a + 5, base - 1);
  pen.fillText("y", ox - 3, base - a - 9);
  pen.fillText("+", ox + 22, base - 16);
}

