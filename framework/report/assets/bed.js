// The bed from the front, as the run's front_view.bin keeps it: decoded once, drawn on a canvas for each case, one clock for all.

// Viridis (van der Walt & Smith 2015): even in lightness, for every kind of eye.
const viridis = [[68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142], [31, 158, 137], [53, 183, 121], [109, 205, 89], [180, 222, 44], [253, 231, 37]];
function viridis_at(share) {
  const at = Math.max(0, Math.min(1, share)) * (viridis.length - 1), k = Math.min(viridis.length - 2, Math.floor(at)), f = at - k;
  return `rgb(${viridis[k].map((c, n) => Math.round(c + f * (viridis[k + 1][n] - c))).join(",")})`;
}

function decode_view(view) {
  const raw = Uint8Array.from(atob(view.base64), (c) => c.charCodeAt(0)), data = new DataView(raw.buffer);
  const bed = { width: data.getFloat64(16, true), height: data.getFloat64(24, true), pictures: [] };
  for (let at = 32; at < raw.length;) {
    const count = data.getUint32(at + 20, true);
    bed.pictures.push({ time: data.getFloat64(at, true), fastest: data.getFloat32(at + 8, true), radius: data.getFloat32(at + 12, true), share: data.getFloat32(at + 16, true), count, rows: new DataView(raw.buffer, at + 24, 6 * count) });
    at += 24 + 6 * count;
  }
  return bed;
}
// The height that 99.8 % of all grains stay below, and some air.
function height_in_use(bed) {
  const heights = [];
  for (const picture of bed.pictures) for (let k = 0; k < picture.count; k += 3) heights.push(picture.rows.getUint16(6 * k + 2, true));
  heights.sort((a, b) => a - b);
  const radius = Math.max(...bed.pictures.map((picture) => picture.radius));
  return Math.min(bed.height, 3 * radius + 1.05 * bed.height * (heights[Math.floor(.998 * (heights.length - 1))] || 65535) / 65535);
}
// A speed that few grains exceed: one outlier must not turn all others violet.
function usual_top_speed(bed) {
  const speeds = [];
  for (const picture of bed.pictures) for (let k = 0; k < picture.count; k += 3) speeds.push(picture.fastest * (picture.rows.getUint8(6 * k + 4) / 255) ** 2);
  speeds.sort((a, b) => a - b);
  return speeds[Math.floor(.99 * (speeds.length - 1))] || 0;
}

function draw_picture(canvas, bed, picture, top, scale, full_speed) {
  const pixels = window.devicePixelRatio || 1;
  const width = Math.round(bed.width * scale), height = Math.round(top * scale);
  if (canvas.width !== width * pixels) { canvas.width = width * pixels; canvas.height = height * pixels; canvas.style.width = `${width}px`; canvas.style.height = `${height}px`; }
  const context = canvas.getContext("2d");
  context.setTransform(pixels, 0, 0, pixels, 0, 0);
  context.clearRect(0, 0, width, height);
  // Where grains are thinned, those left stand for their neighbours and are drawn as much larger.
  const grow = Math.sqrt(1 / Math.max(picture.share, 1e-3));
  for (let k = 0; k < picture.count; ++k) {
    const x = picture.rows.getUint16(6 * k, true) / 65535 * bed.width * scale, z = height - picture.rows.getUint16(6 * k + 2, true) / 65535 * bed.height * scale;
    const radius = Math.max(.6, picture.rows.getUint8(6 * k + 5) / 255 * picture.radius * scale * grow);
    const speed = picture.fastest * (picture.rows.getUint8(6 * k + 4) / 255) ** 2;
    context.fillStyle = viridis_at(full_speed > 0 ? Math.sqrt(speed / full_speed) : 0);
    if (radius < 1.2) { context.fillRect(x - radius, z - radius, 2 * radius, 2 * radius); continue; }
    context.beginPath(); context.arc(x, z, radius, 0, 2 * Math.PI); context.fill();
    if (radius > 2.2) { context.strokeStyle = "rgba(0,0,0,.25)"; context.lineWidth = .6; context.stroke(); }
  }
}

function bed_player(host) {
  const shown = cases.filter((one) => one.run.view).map((one) => ({ one, bed: decode_view(one.run.view) })).filter(({ bed }) => bed.pictures.length > 0);
  if (shown.length === 0) return false;
  const top = Math.max(...shown.map(({ bed }) => height_in_use(bed))), wide = Math.max(...shown.map(({ bed }) => bed.width));
  const full_speed = Math.max(...shown.map(({ bed }) => usual_top_speed(bed)));
  const last = Math.max(...shown.map(({ bed }) => bed.pictures[bed.pictures.length - 1].time));
  const room = Math.max(260, host.clientWidth - 60);
  const each = Math.max(90, Math.min(shown.length === 1 ? 420 : 260, room / shown.length - 22));
  const scale = Math.min(each / wide, 440 / top);
  const figures = shown.map(({ one, bed }) => {
    const canvas = element("canvas", { role: "img", "aria-label": `front view of ${one.name}, grains coloured by speed` });
    const drawn = bed.pictures.reduce((least, picture) => Math.min(least, picture.share), 1);
    const note = drawn < .99 ? `every ${Number((1 / drawn).toPrecision(2))}th visible grain` : null;
    return { one, bed, canvas, figure: element("figure", {}, canvas, element("figcaption", {}, study ? element("b", {}, one.name) : null, note)) };
  });
  const clock = element("output", { for: "bed-time" });
  const slider = element("input", { id: "bed-time", type: "range", min: "0", max: "1000", value: "0", "aria-label": "time of the bed" });
  const play = element("button", { type: "button", id: "bed-play" }, "Play");
  const pace = element("select", { "aria-label": "pace" }, [["8", "whole run in 8 s"], ["20", "in 20 s"], ["60", "in 60 s"]].map(([value, text]) => element("option", { value }, text)));
  const ramp = element("span", { class: "ramp" }, "0", element("i", { style: { background: `linear-gradient(90deg,${[0, .2, .4, .6, .8, 1].map(viridis_at).join(",")})` } }), `${short(full_speed, 2)} m/s and above (square root scale)`);
  host.append(element("div", { class: "player" }, play, slider, clock, pace), element("div", { class: "beds" }, figures.map((f) => f.figure)), ramp);

  let share = 0, playing = false, before = 0;
  function show() {
    const time = share * last;
    for (const { bed, canvas } of figures) {
      let k = 0;
      while (k + 1 < bed.pictures.length && bed.pictures[k + 1].time <= time + 1e-12) ++k;
      draw_picture(canvas, bed, bed.pictures[k], top, scale, full_speed);
    }
    slider.value = String(Math.round(1000 * share));
    clock.textContent = last < .02 ? `${(1e3 * time).toFixed(3)} ms` : `${time.toFixed(last < 1 ? 3 : 2)} s`;
  }
  function tick(now) {
    if (!playing) return;
    share += (now - before) / 1000 / Number(pace.value);
    before = now;
    if (share > 1) share = 0;
    show();
    requestAnimationFrame(tick);
  }
  play.addEventListener("click", () => {
    playing = !playing;
    play.textContent = playing ? "Pause" : "Play";
    if (playing) { before = performance.now(); if (share >= 1) share = 0; requestAnimationFrame(tick); }
  });
  slider.addEventListener("input", () => { share = Number(slider.value) / 1000; show(); });
  share = 1;
  show();
  return true;
}
