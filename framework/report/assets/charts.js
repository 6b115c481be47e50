// What all charts share: their look, error bars, names beside points, and being drawn anew when the theme changes.
const charts = [];   // {canvas, make, chart}

function chart(host, name, make, low = false) {
  const canvas = element("canvas", { role: "img", "aria-label": name });
  host.append(element("div", { class: low ? "chart low" : "chart" }, canvas));
  const entry = { canvas, make, chart: null, name };
  charts.push(entry);
  entry.draw = () => {
    const hidden = new Set();
    if (entry.chart) {
      entry.chart.data.datasets.forEach((set, k) => { if (!entry.chart.isDatasetVisible(k)) hidden.add(set.label); });
      entry.chart.destroy();
    }
    const configuration = make();
    configuration.data.datasets.forEach((set) => { if (hidden.has(set.label)) set.hidden = true; });
    entry.chart = new Chart(canvas, configuration);
  };
  entry.draw();
  return entry;
}

function look() {
  Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
  Chart.defaults.font.size = 13;
  Chart.defaults.color = css("--soft");
  Chart.defaults.borderColor = css("--grid");
  Chart.defaults.animation = false;
  Chart.defaults.responsive = true;
  Chart.defaults.maintainAspectRatio = false;
  Chart.defaults.plugins.legend.labels.usePointStyle = true;
  Chart.defaults.plugins.legend.labels.boxHeight = 7;
  Chart.defaults.plugins.legend.labels.padding = 14;
  Chart.defaults.plugins.tooltip.boxPadding = 5;
  Chart.defaults.plugins.tooltip.padding = 10;
}

function axis(text, more = {}) {
  return { title: { display: true, text, color: css("--ink") }, border: { color: css("--line") }, grid: { color: css("--grid") }, ...more };
}
// Marks of a logarithmic axis: as many round numbers as there is room for, 1 alone in each power of ten or up to nine.
const rounds = [[1, 1.2, 1.4, 1.6, 1.8, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9], [1, 1.5, 2, 3, 4, 5, 7], [1, 2, 5], [1, 3], [1]];
function log_axis(text, words, more = {}) {
  return axis(text, {
    type: "logarithmic", ticks: { callback: (value) => words(value), maxRotation: 0, autoSkip: false },
    afterBuildTicks: (scale) => {
      const low = Math.floor(Math.log10(scale.min)), high = Math.ceil(Math.log10(scale.max));
      for (const round of rounds) {
        scale.ticks = [];
        for (let power = low; power <= high; ++power) for (const digit of round) {
          const value = Number((digit * 10 ** power).toPrecision(3));
          if (value >= scale.min && value <= scale.max) scale.ticks.push({ value });
        }
        if (scale.ticks.length <= 8) return;
      }
    },
    ...more });
}
function line_style(index) {
  const paint = colour(index);
  return { borderColor: paint, backgroundColor: paint, pointStyle: marks[index % marks.length], borderDash: dashes[index % dashes.length], borderWidth: 2 };
}

// Points with `low` and `high` get a bar between them; one that is a lower bound ends in arrows, since the truth may lie farther.
const error_bars = {
  id: "error_bars",
  beforeDatasetsDraw(chart) {
    const { ctx, scales: { y }, chartArea: area } = chart;
    chart.data.datasets.forEach((set, k) => {
      if (!chart.isDatasetVisible(k) || !set.bars) return;
      ctx.save();
      ctx.beginPath(); ctx.rect(area.left, area.top - 6, area.width, area.height + 12); ctx.clip();
      ctx.strokeStyle = set.borderColor; ctx.lineWidth = 1.4; ctx.globalAlpha = set.bar_alpha || 1;
      chart.getDatasetMeta(k).data.forEach((point, n) => {
        const at = set.data[n];
        if (!known(at.low) || !known(at.high) || at.high === at.low) return;
        const ends = [y.getPixelForValue(at.low), y.getPixelForValue(at.high)];
        ctx.beginPath(); ctx.moveTo(point.x, ends[0]); ctx.lineTo(point.x, ends[1]);
        ends.forEach((end, side) => {
          const tip = at.lower_bound && (side === 1 || at.low > 0) ? (side === 0 ? -5 : 5) : 0;
          ctx.moveTo(point.x - 5, end + tip); ctx.lineTo(point.x, end); ctx.lineTo(point.x + 5, end + tip);
        });
        ctx.stroke();
      });
      ctx.restore();
    });
  },
};

// Names beside single points, moved down where two would meet.
const names = {
  id: "names",
  afterDatasetsDraw(chart) {
    const { ctx, chartArea: area } = chart;
    const taken = [];
    ctx.save();
    ctx.font = `600 13px ${Chart.defaults.font.family}`; ctx.textBaseline = "middle";
    chart.data.datasets.forEach((set, k) => {
      if (!set.named || !chart.isDatasetVisible(k)) return;
      const point = chart.getDatasetMeta(k).data[0];
      if (!point) return;
      const width = ctx.measureText(set.label).width;
      const left = point.x + 11 + width > area.right ? point.x - 11 - width : point.x + 11;
      let y = point.y - 9;
      while (taken.some((box) => left < box.right && left + width > box.left && Math.abs(box.y - y) < 15)) y -= 15;
      if (y < area.top + 8) y = point.y + 12;
      while (taken.some((box) => left < box.right && left + width > box.left && Math.abs(box.y - y) < 15)) y += 15;
      taken.push({ left, right: left + width, y });
      ctx.fillStyle = css("--card"); ctx.globalAlpha = .8; ctx.fillRect(left - 2, y - 8, width + 4, 16);
      ctx.globalAlpha = 1; ctx.fillStyle = set.borderColor; ctx.fillText(set.label, left, y);
    });
    ctx.restore();
  },
};

// ------------------------------------------------------------------------------------------------------------ frontier
function frontier_chart(metric) {
  const shown = cases.filter((one) => known(one.wall_s) && one.error && one.error[metric] && known(one.error[metric].value));
  const sets = shown.map((one) => {
    const e = one.error[metric];
    return { type: "scatter", label: one.name, ...line_style(one.index), borderDash: [], bars: true, named: true, pointRadius: one.reference ? 8 : 6, pointHoverRadius: 9,
      pointBackgroundColor: one.reference ? css("--card") : colour(one.index), pointBorderWidth: 2.4,
      data: [{ x: one.wall_s, y: 100 * e.value, low: 100 * e.low, high: 100 * e.high, lower_bound: e.lower_bound }] };
  });
  const on = metric === study.frontier.metric ? shown.filter((one) => one.pareto).sort((a, b) => a.wall_s - b.wall_s) : [];
  if (on.length > 1)
    sets.push({ type: "line", label: "frontier: nothing beats these in both", borderColor: css("--soft"), backgroundColor: css("--soft"), borderWidth: 1.5, pointRadius: 0, pointStyle: "line", pointHitRadius: 0,
      stepped: "before", data: on.map((one) => ({ x: one.wall_s, y: 100 * one.error[metric].value })) });
  const walls = shown.map((one) => one.wall_s);
  const reference = cases.find((one) => one.reference);
  return {
    data: { datasets: sets }, plugins: [error_bars, names],
    options: {
      layout: { padding: { top: 18, right: 26 } },
      scales: {
        x: log_axis("wall time", seconds, { min: Math.min(...walls) / 1.35, max: Math.max(...walls) * 1.5 }),
        y: axis(`${metric_words(metric).toLowerCase()} error [%]`, { beginAtZero: true, suggestedMax: Math.max(...shown.map((one) => 100 * one.error[metric].high)) * 1.08 }),
      },
      plugins: { legend: { position: "bottom" }, tooltip: { callbacks: {
        title: (items) => items[0].dataset.label,
        label: (item) => {
          const one = shown.find((c) => c.name === item.dataset.label);
          if (!one) return "";
          const ratio = reference && known(reference.wall_s) && !one.reference ? `, ${short(reference.wall_s / one.wall_s, 2)} × the reference's speed` : "";
          const e = one.error[metric];
          return [`${seconds(one.wall_s)}${ratio}`, `error ${error_words(e)}${e.lower_bound ? " (interval: a lower bound)" : ""}`, `${whole(one.particles)} particles`];
        },
      } } },
    },
  };
}

// ------------------------------------------------------------------------------------------------------------ profiles
// 97.5 % quantile of Student's t by its expansion about the normal's: Abramowitz & Stegun (1964), 26.7.5.
function student(freedom) {
  const z = 1.959963985, n = freedom;
  return z + (z ** 3 + z) / (4 * n) + (5 * z ** 5 + 16 * z ** 3 + 3 * z) / (96 * n * n) + (3 * z ** 7 + 19 * z ** 5 + 17 * z ** 3 - 15 * z) / (384 * n ** 3);
}
function profile_curves(sampler, z) {
  const curves = cases.map((one) => ({ one, list: study ? one.profiles : one.run.profiles }));
  if (study && study.reference.profiles.length > 0)
    curves.push({ one: { name: study.reference.name, index: cases.length, reference: true }, list: study.reference.profiles });
  return curves.map(({ one, list }) => {
    const found = (list || []).find((p) => p.sampler === sampler);
    return { one, bins: found ? found.bins.filter((bin) => Math.abs(bin.z - z) < 1e-9 + 1e-6 * z && known(bin.mean)) : [] };
  }).filter((curve) => curve.bins.length > 0);
}
// Room for the bars: a chart sees its points only.
function reach(sets) {
  const ends = sets.flatMap((set) => set.data.flatMap((at) => [known(at.low) ? at.low : at.y, known(at.high) ? at.high : at.y]));
  return { suggestedMin: Math.min(...ends), suggestedMax: Math.max(...ends) };
}
function profile_chart(sampler, z) {
  const curves = profile_curves(sampler, z);
  const widths = curves.flatMap(({ bins }) => bins.slice(1).map((bin, k) => bin.x - bins[k].x));
  const step = widths.length > 0 ? Math.min(...widths) : 0;
  const sets = curves.map(({ one, bins }, k) => ({
    type: "line", label: one.name, ...line_style(one.index), bars: true, bar_alpha: .55, pointRadius: 3.2, tension: 0,
    data: bins.map((bin) => {
      const half = known(bin.standard_error) && bin.blocks >= 4 ? student(bin.blocks - 1) * bin.standard_error : NaN;
      return { x: 1e3 * (bin.x + (k - (curves.length - 1) / 2) * .035 * step), y: bin.mean, low: bin.mean - half, high: bin.mean + half, bin };
    }),
  }));
  return {
    data: { datasets: sets }, plugins: [error_bars],
    options: {
      interaction: { mode: "nearest", intersect: false },
      scales: { x: axis("x [mm]", { type: "linear" }), y: axis(sampler.replace(/_/g, " "), reach(sets)) },
      plugins: { legend: { position: "bottom", display: curves.length > 1 }, tooltip: { callbacks: {
        title: (items) => items[0].dataset.label,
        label: (item) => `x = ${short(1e3 * item.raw.bin.x, 4)} mm: ${short(item.raw.y, 4)}` + (known(item.raw.high) ? ` ± ${short(item.raw.high - item.raw.y, 2)}` : ""),
      } } },
    },
  };
}

// -------------------------------------------------------------------------------------------------------------- stages
const shown_stages = 8;   // the rest is one piece: a bar with twenty colours tells nothing

function stages_of(list, names) {
  const seconds_by = Object.fromEntries((list || []).map((stage) => [stage.name, stage.seconds]));
  const all = Object.values(seconds_by).reduce((a, b) => a + b, 0);
  const named = names.map((name) => seconds_by[name] || 0);
  return [...named, all - named.reduce((a, b) => a + b, 0)];
}
function measured_stages(one) { return study ? one.stages : (one.run.timing || {}).stages; }
function predicted_stages(one) { return one.predicted && one.predicted.stages ? one.predicted.stages : null; }

function largest_stages() {
  const sums = {};
  for (const one of cases) for (const stage of measured_stages(one) || []) sums[stage.name] = (sums[stage.name] || 0) + stage.seconds;
  return Object.entries(sums).filter(([name]) => name !== "other").sort((a, b) => b[1] - a[1]).slice(0, shown_stages).map(([name]) => name);
}
function stage_chart(relative) {
  const timed = cases.filter((one) => (measured_stages(one) || []).length > 0);
  const names = largest_stages();
  const with_prediction = timed.some(predicted_stages);
  const measured = timed.map((one) => stages_of(measured_stages(one), names));
  const predicted = timed.map((one) => stages_of(predicted_stages(one), names));
  const total = measured.map((row) => relative ? row.reduce((a, b) => a + b, 0) / 100 : 1);
  const sets = [];
  [...names, "everything else"].forEach((name, k) => {
    const paint = k === names.length ? css("--line") : colour(k);
    sets.push({ label: name, stack: "measured", backgroundColor: paint, borderColor: css("--card"), borderWidth: 1, data: measured.map((row, n) => row[k] / total[n]) });
    if (with_prediction) sets.push({ label: name, stack: "predicted", predicted: true, backgroundColor: paint + (paint.length === 7 ? "80" : ""), borderColor: paint, borderWidth: 1, data: predicted.map((row, n) => row[k] / total[n]) });
  });
  return {
    type: "bar", data: { labels: timed.map((one) => one.name), datasets: sets },
    options: {
      indexAxis: "y",
      scales: { x: axis(relative ? "share of the measured wall time [%]" : "wall time [s]", { stacked: true }), y: { stacked: true, grid: { display: false }, ticks: { color: css("--ink") } } },
      plugins: {
        legend: {
          position: "bottom", labels: { usePointStyle: false, boxWidth: 12, boxHeight: 12, filter: (item, data) => !data.datasets[item.datasetIndex].predicted },
          onClick: (event, item, legend) => {
            const show = !legend.chart.isDatasetVisible(item.datasetIndex);
            legend.chart.data.datasets.forEach((set, k) => { if (set.label === item.text) legend.chart.setDatasetVisibility(k, show); });
            legend.chart.update();
          },
        },
        tooltip: { callbacks: { label: (item) => `${item.dataset.label}${item.dataset.predicted ? ", predicted" : ""}: ${relative ? `${short(item.raw)} %` : seconds(item.raw)}` } },
      },
    },
  };
}

// -------------------------------------------------------------------------------------------------------- time series
function column_of(one, name) {
  const monitors = one.run.monitors;
  if (!monitors || !monitors.columns[name]) return null;
  const values = monitors.columns[name];
  return values.some(known) ? values : null;
}
function points(one, values) { return values.map((value, k) => ({ x: one.run.monitors.columns["time [s]"][k], y: value })); }

function series_chart(column) {
  const sets = cases.filter((one) => column_of(one, column)).map((one) => ({ type: "line", label: one.name, ...line_style(one.index), borderWidth: 1.6, pointRadius: 0, data: points(one, column_of(one, column)) }));
  return time_chart(sets, column);
}
function budget_chart(one, budget) {
  const sets = budget.columns.filter((name) => column_of(one, name)).map((name, k) => ({
    type: "line", label: name.replace(/ \[.*/, "").replace(/_/g, " "), ...line_style(k), borderWidth: 1.8, pointRadius: 0,
    data: points(one, budget.log ? column_of(one, name).map((value) => known(value) && value !== 0 ? Math.abs(value) : null) : column_of(one, name)) }));
  return time_chart(sets, budget.unit, budget.log);
}
function time_chart(sets, unit, log = false) {
  return {
    data: { datasets: sets },
    options: {
      interaction: { mode: "nearest", axis: "x", intersect: false },
      scales: { x: axis("time of the bed [s]", { type: "linear" }), y: log ? axis(unit, { type: "logarithmic" }) : axis(unit) },
      plugins: { legend: { position: "bottom", display: sets.length > 1 }, tooltip: { callbacks: { title: (items) => `t = ${short(items[0].raw.x, 4)} s`, label: (item) => `${item.dataset.label}: ${short(item.raw.y, 4)}` } } },
    },
  };
}
