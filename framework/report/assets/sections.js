// The page from top to bottom.
document.documentElement.dataset.theme = window.matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
look();

const main = document.getElementById("main");
const first_manifest = (runs.find((run) => run.manifest) || {}).manifest || {};
const machine = study ? study.machine : first_manifest.machine || {};
const threads = study ? study.threads : first_manifest.threads;

function fact(name, value) { return element("div", {}, element("dt", {}, name), element("dd", {}, value)); }
function settings_words(one) {
  const entries = Object.entries(one.settings || {});
  return entries.length === 0 ? "the base case" : entries.map(([path, value]) => `${path}: ${value}`).join("; ");
}

function head() {
  main.append(element("h1", {}, numbers.title));
  if (study) {
    main.append(element("p", { class: "under" }, `${study.cases.length} cases against ${study.reference.name}, on ${machine.processor}, ${threads} ${threads === 1 ? "thread" : "threads"}. Intervals are 95 %.`),
      element("p", { class: "advice", id: "advice" }, study.advice));
    return;
  }
  const manifest = first_manifest, timing = runs[0].timing || {};
  const state = manifest.status === "done" ? "reached its end" : `${manifest.status}${manifest.exit_reason ? `: ${manifest.exit_reason}` : ""}`;
  main.append(element("p", { class: "under" }, `${manifest.case_file || ""} · ${state} · ${manifest.started || ""}`),
    element("dl", { class: "facts" }, fact("grains simulated", whole(manifest.particles)), fact("time of the bed", `${short(manifest.simulated_s)} s`), fact("wall time", seconds(timing.wall_s)),
      fact("grain-steps per second", known(timing.particle_steps_per_s) ? `${short(timing.particle_steps_per_s / 1e6)} M` : "–"), fact("scaling law", (manifest.scaling || {}).law || "–"), fact("threads", whole(threads))));
}

// ------------------------------------------------------------------------------------------------------------ frontier
function frontier_section() {
  const metrics = study.metrics.map((m) => m.name).filter((name) => cases.some((one) => known(one.wall_s) && one.error[name] && known(one.error[name].value)));
  const made = section("frontier", "Accuracy and cost", "Accuracy and cost", `Left is faster, low is closer to ${study.reference.name}. Bars are 95 % intervals; one that ends in arrows is a lower bound, because the run holds fewer than 20 independent samples. Two cases whose bars overlap cannot be told apart.`);
  const metric_doc = element("p", { class: "says" });
  let metric = metrics[0];
  const says = () => { metric_doc.textContent = (study.metrics.find((m) => m.name === metric) || {}).doc || ""; };
  if (metrics.length === 0) {
    made.append(element("p", { class: "gap" }, "No case has both a wall time and an error."));
  } else {
    const host = element("div", {});
    let entry = null;
    made.append(element("div", { class: "controls" }, chooser("Metric", metrics.map((name) => [name, metric_words(name)]), (value) => { metric = value; says(); entry.draw(); })), metric_doc, host);
    says();
    entry = chart(host, "wall time against error of every case", () => frontier_chart(metric));
  }
  const reference = cases.find((one) => one.reference);
  const rows = cases.map((one) => element("tr", { class: one.pareto ? "best" : null }, (() => {
    const header = case_head(one);
    if (one.pareto) header.append(element("span", { class: "badge", title: "no other case beats it in both time and error" }, "frontier"));
    return header;
  })(),
    one.status === "done" ? cell(one.wall_s, seconds(one.wall_s) + (one.extrapolated_from_s ? " (scaled up)" : ""), `${one.path}.wall_s`) : gap_cell(`${one.name} is ${one.status}${one.reason ? `: ${one.reason}` : ""}`),
    cell(NaN, reference && known(reference.wall_s) && known(one.wall_s) && !one.reference ? `${short(reference.wall_s / one.wall_s, 2)} ×` : "–"),
    cell(one.particles, whole(one.particles), `${one.path}.particles`),
    ...study.metrics.map((m) => {
      const e = (one.error || {})[m.name];
      if (one.reference && e && e.value === 0) return cell(e.value, "0", `${one.path}.error.${m.name}.value`);
      return error_words(e) ? cell(e.value, error_words(e), `${one.path}.error.${m.name}.value`) : gap_cell(e && e.gap);
    })));
  made.append(table("Wall time, and the error by every metric", ["case", "wall time", "speed, reference = 1", "grains", ...study.metrics.map((m) => metric_words(m.name))], rows));
  if (study.frontier.steps.length > 0)
    made.append(element("h3", {}, "The price of each step along the frontier"), element("ul", { class: "plain" }, study.frontier.steps.map((step) => element("li", {}, `${step.from} → ${step.to}: ${short(step.time_ratio, 2)} × the time, ${Number((100 * step.error_change).toPrecision(2))} % of error${step.distinguishable ? "" : ", not distinguishable"}`))));
  const alike = Object.entries(study.indistinguishable).filter(([, pairs]) => pairs.length > 0);
  if (alike.length > 0)
    made.append(element("details", {}, element("summary", {}, "Which cases cannot be told apart"), element("ul", { class: "plain" }, alike.map(([name, pairs]) => element("li", {}, `${metric_words(name)}: ${pairs.map((pair) => pair.join(" and ")).join("; ")}`)))));
  const values = cases.filter((one) => one.status === "done").map((one) => element("tr", {}, case_head(one), element("td", { class: "words" }, settings_words(one)), ...study.metrics.map((m) => {
    const v = one.metrics[m.name];
    return v && known(v.value) ? cell(v.value, `${short(v.value, 4)}${v.unit && v.unit !== "1" ? ` ${v.unit}` : ""}`, `${one.path}.metrics.${m.name}.value`) : gap_cell(v && v.gap);
  })));
  made.append(element("details", {}, element("summary", {}, "What differs between the cases, and the values behind the errors"), table("Settings and values", ["case", "settings", ...study.metrics.map((m) => metric_words(m.name))], values, [1])));
}

function order_section() {
  if (!study.orders || study.orders.length === 0) return;
  section("orders", "Orders", "Observed orders", "p in error ~ step to the power p, from the cases whose error stands out of the noise. Where none does, the bed has a plateau: finer steps buy nothing that this run could see.",
    table("Orders along each axis", ["axis", "metric", "order", "95 % interval", "cases"], study.orders.map((one, k) => element("tr", {}, element("th", { scope: "row" }, one.axis), element("td", { class: "words" }, metric_words(one.metric)),
      known(one.order.value) ? cell(one.order.value, short(one.order.value), `orders.${k}.order.value`) : gap_cell(one.order.gap),
      element("td", {}, known(one.order.low) ? `${short(one.order.low, 2)} … ${short(one.order.high, 2)}` : "–"), element("td", { class: "words" }, one.cases.join(", ")))), [1, 4]));
}

// ------------------------------------------------------------------------------------------------------------ profiles
function profile_section() {
  const choices = [];
  for (const one of cases)
    for (const profile of (study ? one.profiles : one.run.profiles) || [])
      for (const bin of profile.bins) if (!choices.some(([s, z]) => s === profile.sampler && Math.abs(z - bin.z) < 1e-9)) choices.push([profile.sampler, bin.z]);
  const usable = choices.filter(([sampler, z]) => profile_curves(sampler, z).length > 0);
  if (usable.length === 0) return;
  let chosen = usable[0], entry = null;
  const host = element("div", {}), behind = element("div", {});
  const made = section("profiles", "Profiles", "Profiles across the bed", `Averages over time${study ? ", all cases over one another" : ""}. Bars are 95 % intervals from block averages; bins seen in fewer than four independent blocks carry none.`);
  made.append(element("div", { class: "controls" }, chooser("Profile", usable.map(([sampler, z], k) => [String(k), `${sampler.replace(/_/g, " ")} at z = ${short(1e3 * z, 4)} mm`]), (value) => { chosen = usable[Number(value)]; entry.draw(); tabulate(); })), host, element("details", {}, element("summary", {}, "The numbers of this chart"), behind));
  entry = chart(host, "profiles across the bed", () => profile_chart(...chosen));
  function tabulate() {
    const curves = profile_curves(...chosen), places = [...new Set(curves.flatMap(({ bins }) => bins.map((bin) => bin.x)))].sort((a, b) => a - b);
    behind.replaceChildren(table(`${chosen[0]} at z = ${short(1e3 * chosen[1], 4)} mm, ± standard error`, ["x [mm]", ...curves.map(({ one }) => one.name)], places.map((x) => element("tr", {}, element("th", { scope: "row" }, short(1e3 * x, 4)), ...curves.map(({ bins }) => {
      const bin = bins.find((b) => b.x === x);
      return bin ? cell(bin.mean, `${short(bin.mean, 4)}${known(bin.standard_error) ? ` ± ${short(bin.standard_error, 2)}` : ""}`) : gap_cell();
    })))));
  }
  tabulate();
}

// ---------------------------------------------------------------------------------------------------------------- cost
function cost_section() {
  const timed = cases.filter((one) => (measured_stages(one) || []).length > 0);
  if (timed.length === 0) return;
  const predicted = timed.some(predicted_stages);
  const made = section("cost", "Time", "Where the time goes", predicted ? "Full bars are measured, pale ones what a short calibration foretold before the run." : "Wall time of the parts of a step.");
  const host = element("div", {});
  let relative = false, entry = null;
  made.append(element("div", { class: "controls" }, chooser("Bars show", [["s", "wall time"], ["share", "share of the wall time"]], (value) => { relative = value === "share"; entry.draw(); })), host);
  entry = chart(host, "wall time by stage", () => stage_chart(relative));
  host.firstChild.style.height = `${120 + 44 * timed.length * (predicted ? 1.25 : 1)}px`;
  entry.chart.resize();
  const names = largest_stages();
  const rows = timed.map((one) => {
    const list = measured_stages(one), of = (name) => list.findIndex((stage) => stage.name === name);
    return element("tr", {}, case_head(one), ...names.map((name) => of(name) < 0 ? gap_cell() : cell(list[of(name)].seconds, `${short(list[of(name)].seconds)} s`, study ? `${one.path}.stages.${of(name)}.seconds` : null)),
      study ? cell(one.particle_steps_per_s, `${short(one.particle_steps_per_s / 1e6)} M`, `${one.path}.particle_steps_per_s`) : null,
      study ? cell(one.peak_memory_bytes, bytes(one.peak_memory_bytes), `${one.path}.peak_memory_bytes`) : null);
  });
  made.append(table("Seconds of the largest stages", ["case", ...names, ...(study ? ["grain-steps per second", "peak memory"] : [])], rows));
  if (study) prediction(made);
}
function prediction(made) {
  if (!cases.some((one) => one.predicted)) return;
  made.append(element("h3", {}, "Predicted against measured"), table("What the calibration foretold", ["case", "predicted", "measured", "predicted / measured", "particle-steps, predicted / done", "farthest off"], cases.filter((one) => one.status === "done").map((one) => {
    const p = one.predicted;
    if (!p || !known(p.wall_s)) return element("tr", {}, case_head(one), gap_cell((p && p.gap) || "not predicted"), cell(one.wall_s, seconds(one.wall_s), `${one.path}.wall_s`), gap_cell(), gap_cell(), gap_cell());
    return element("tr", {}, case_head(one), cell(p.wall_s, seconds(p.wall_s), `${one.path}.predicted.wall_s`), cell(one.wall_s, seconds(one.wall_s), `${one.path}.wall_s`),
      cell(NaN, short(p.wall_s / one.wall_s, 2)), cell(NaN, short(p.particle_steps / one.particle_steps, 3)), element("td", { class: "words" }, p.farthest_off || "–"));
  }), [5]));
}

// --------------------------------------------------------------------------------------------------------------- audit
function audit_section() {
  const audited = cases.filter((one) => one.run.audit && one.run.audit.groups.length > 0);
  if (audited.length === 0) return;
  const laws = [];
  for (const one of audited) {
    const key = JSON.stringify(one.run.audit.groups.map((g) => g.ratio));
    const same = laws.find((law) => law.key === key && law.audit.law === one.run.audit.law);
    if (same) same.names.push(one.name); else laws.push({ key, audit: one.run.audit, names: [one.name] });
  }
  const groups = laws[0].audit.groups.map((g) => g.name);
  const heads = laws.map((law) => laws.length === 1 ? law.audit.law : `${law.audit.law}${study ? `: ${law.names.join(", ")}` : ""}`);
  const made = section("audit", "Scaling", "What the scaling law keeps", "Dimensionless groups of the simulated bed over those of the real one. Kept means within 0.1 %.");
  if (laws.length === 1 && laws[0].audit.law === "exact") made.querySelector(".says").textContent = "The bed was simulated as it is: every group is kept.";
  made.append(table("Simulated over real", ["group", "meaning", "real bed", ...heads], groups.map((name) => {
    const real = laws[0].audit.groups.find((g) => g.name === name);
    return element("tr", {}, element("th", { scope: "row" }, name), element("td", { class: "words" }, real.meaning), cell(NaN, short(real.exact)), ...laws.map((law) => {
      const group = law.audit.groups.find((g) => g.name === name);
      return group ? element("td", { class: group.kept ? "kept" : "lost" }, group.kept ? "kept" : `× ${short(group.ratio)}`) : gap_cell();
    }));
  }), [1]));
  for (const law of laws) if (law.audit.warnings.length > 0)
    made.append(element("h3", {}, laws.length === 1 ? "What that means here" : `${law.audit.law}: what that means here`), element("ul", { class: "plain" }, law.audit.warnings.map((text) => element("li", {}, text))));
}

// ------------------------------------------------------------------------------------------------------- along the run
const budgets = [
  { name: "Solids' momentum, upward", unit: "kg m/s", columns: ["solids_momentum_z [kg m/s]", "gravity_impulse_z [kg m/s]", "drag_impulse_z [kg m/s]", "stress_impulse_z [kg m/s]", "wall_impulse_z [kg m/s]"] },
  { name: "Solids' energy", unit: "J", columns: ["kinetic_energy [J]", "gravity_work [J]", "drag_work [J]", "stress_work [J]", "contact_work [J]"] },
  { name: "Gas through the patches", unit: "kg/s", columns: ["inflow [kg/s]", "outflow [kg/s]"] },
  { name: "What the books are off by", unit: "share of what was exchanged", log: true, columns: ["momentum_residual [1]", "energy_residual [1]", "gas_balance_residual [1]", "gas_mass_residual [1]", "gas_momentum_residual [1]"] },
];
function series_section() {
  const columns = ["pressure_drop [Pa]", "bed_height [m]", "mean_height [m]", "kinetic_energy [J]", "largest_speed [m/s]", "largest_overlap [% of d]", "contacts [1]", "smallest_gas_fraction [1]", "courant [1]", "pressure_iterations [1]", "particles [1]"]
    .filter((column) => cases.some((one) => column_of(one, column)));
  if (columns.length === 0) return;
  let column = columns[0], entry = null;
  const thinned = Math.max(...cases.map((one) => (one.run.monitors || { every: 1 }).every));
  const host = element("div", {});
  const made = section("series", "Along the run", "Along the run", `From monitors.csv${thinned > 1 ? "; long series are thinned for the charts" : ""}.`);
  made.append(element("div", { class: "controls" }, chooser("Series", columns.map((name) => [name, name.replace(/_/g, " ")]), (value) => { column = value; entry.draw(); })), host);
  entry = chart(host, "a monitor along the run", () => series_chart(column), true);

  const with_series = cases.filter((one) => one.run.monitors), possible = budgets.filter((budget) => with_series.some((one) => budget.columns.some((name) => column_of(one, name))));
  if (possible.length === 0) return;
  let one = with_series[0], budget = possible[0], second = null;
  const budget_host = element("div", {}), behind = element("div", {});
  const last_of = () => {
    const rows = budget.columns.filter((name) => column_of(one, name)).map((name) => { const values = column_of(one, name).filter(known); return element("tr", {}, element("th", { scope: "row" }, name), cell(values[0], short(values[0], 4)), cell(values[values.length - 1], short(values[values.length - 1], 4)), cell(NaN, short(Math.max(...values.map(Math.abs)), 4))); });
    behind.replaceChildren(table(`${budget.name}: ${one.name}`, ["column of monitors.csv", "first", "last", "largest magnitude"], rows));
  };
  made.append(element("h3", {}, "Budgets"), element("div", { class: "controls" }, chooser("Budget", possible.map((b, k) => [String(k), b.name]), (value) => { budget = possible[Number(value)]; second.draw(); last_of(); }),
    with_series.length > 1 ? chooser("Case", with_series.map((c, k) => [String(k), c.name]), (value) => { one = with_series[Number(value)]; second.draw(); last_of(); }) : null), budget_host, behind);
  second = chart(budget_host, "a budget along the run", () => budget_chart(one, budget), true);
  last_of();
}

function bed_section() {
  const made = section("bed", "The bed", "The bed from the front", study ? "All cases at the same instant and on the same scales, grains coloured by their speed." : "Grains coloured by their speed.");
  if (!bed_player(made)) made.append(element("p", { class: "gap" }, "No pictures were kept (front_view.bin is missing)."));
}

// ---------------------------------------------------------------------------------------------------------- provenance
function origin_section() {
  const items = [];
  if (study) {
    items.push(["study", study.study_file], ["base case", study.base], ["program", `${study.program.name} ${study.program.version}`], ["machine", `${machine.processor}, ${machine.cores} cores, ${machine.kernel}`], ["smoothing length", known(study.smoothing_m) ? `${short(1e3 * study.smoothing_m)} mm for all cases` : "each case its own"]);
  } else {
    const m = first_manifest;
    items.push(["command", m.command], ["program", m.program ? `${m.program.name} ${m.program.version}` : null], ["machine", machine.processor ? `${machine.processor}, ${machine.cores} cores, ${machine.kernel}` : null], ["state", m.state_hash]);
  }
  const made = section("origin", "Origin", "Where this comes from", null, table("Origin", ["", ""], items.filter(([, value]) => value).map(([name, value]) => element("tr", {}, element("th", { scope: "row" }, name), element("td", { class: "words" }, value))), [1]));
  const hashes = cases.filter((one) => one.run.manifest);
  made.append(element("details", {}, element("summary", {}, "Plugins and states"), ...hashes.map((one) => element("div", {}, element("h3", {}, `${one.name}: state ${one.run.manifest.state_hash || "none"}`),
    element("ul", { class: "plain" }, (one.run.manifest.plugins || []).map((p) => element("li", {}, `${p.kind} ${p.id} ${p.version}, SHA-256 ${String(p.sha256).slice(0, 16)}…`)))))));
  if (!study && first_manifest.case) made.append(element("details", {}, element("summary", {}, "The case with every default filled in"), element("pre", {}, JSON.stringify(first_manifest.case, null, 2))));
}

head();
if (study) frontier_section();
bed_section();
profile_section();
if (study) order_section();
cost_section();
audit_section();
series_section();
origin_section();

document.getElementById("theme").addEventListener("click", () => {
  document.documentElement.dataset.theme = theme() === "dark" ? "light" : "dark";
  look();
  document.querySelectorAll("[data-swatch]").forEach((swatch) => { swatch.style.background = colour(Number(swatch.dataset.swatch)); });
  for (const entry of charts) entry.draw();
});
document.documentElement.dataset.ready = "true";
