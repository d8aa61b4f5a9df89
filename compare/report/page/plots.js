// Plots with values under the pointer and zoom, by uPlot, in the place of the page's drawings. Each figure with a block
// of class plot-data becomes one when it comes near the screen; paper gets the drawing. The axes are read from the
// drawing (data-axes: low and high of x and y, as logarithms where data-log names the axis; data-x, data-y: labels),
// the curves from the block:
//   lines   name (in the legend; empty: not there), source (its colour), faint, dashed, points (a dot at every value),
//           x and y: base64 of 32-bit floats; what is not finite interrupts the line
//   bands   source, from, to, value, half_width: settled means with their intervals
//   levels  name, value: horizontal references
import uPlot from 'uplot';
import libraryStyle from 'uplot/dist/uPlot.min.css';

const style = libraryStyle + `
figure.live>svg.plot{display:none}
.plot-live{position:relative}.plot-live .plot-title{font-size:13.5px;font-weight:600;margin-left:66px}
.plot-live .plot-box:focus-visible{outline:2px solid var(--s0)}
.plot-live .u-legend{font-size:13px;text-align:left;margin-left:60px;color:var(--text);line-height:1.3;width:auto}
.plot-live .u-legend tr{border:0}
.plot-live .u-legend th,.plot-live .u-legend td{border:0;padding:1px 3px;font-size:13px;color:var(--text)}
.plot-live .u-legend td{font-variant-numeric:tabular-nums}.plot-live .u-unnamed{display:none}
.plot-live .u-select{background:var(--soft);opacity:.25}.plot-live .u-hz .u-cursor-x{border-color:var(--soft)}
.plot-said{position:absolute;width:1px;height:1px;overflow:hidden;clip-path:inset(50%)}
@media print{figure.live>svg.plot{display:block}.plot-live{display:none}}`;
document.head.append(Object.assign(document.createElement('style'), {textContent: style}));

const made = (name, properties) => Object.assign(document.createElement(name), properties);
const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const floats = base64 => new Float32Array(Uint8Array.from(atob(base64), c => c.charCodeAt(0)).buffer);
const reach = 20;  // of the pointer: a curve that is farther away along x tells no value [px]

/** The line's points in increasing x, one for each x; null: they do not follow each other along x. */
function alongX(line) {
  const points = Array.from(line.x, (x, i) => [x, Number.isFinite(line.y[i]) ? line.y[i] : null]);
  if (points.length > 1 && points[0][0] > points[points.length - 1][0]) points.reverse();
  if (points.some(([x], i) => i > 0 && x < points[i - 1][0])) return null;
  const single = points.filter(([x], i) => i === 0 || x > points[i - 1][0]);
  return 2 * single.length > points.length ? [single.map(p => p[0]), single.map(p => p[1])] : null;
}

/** Decimal places of a number of this size; of an exact step between ticks, all of its own: 0.25 has two. */
function placesOf(step, exact) {
  let places = Math.min(8, Math.max(0, Math.ceil(-Math.log10(step))));
  while (exact && places < 8 && Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) > 1e-6) ++places;
  return places;
}

/** A number with the digits that a step of this size shows. */
function shown(value, step, logarithmic, exact = false) {
  if (value == null) return '–';
  const places = placesOf(step, exact);
  const text = logarithmic || Math.abs(value) >= 1e6 ? Number(value.toPrecision(4)).toString() : value.toFixed(places);
  return text.replace(/^-(?=0(\.0*)?$)/, '').replace('-', '−');
}

/** Decades within the range, and 2 and 5 of each where there are fewer than four. */
function logarithmicTicks(low, high) {
  const digits = Math.log10(high / low) < 4 ? [1, 2, 5] : [1], ticks = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); ++power)
    for (const digit of digits) {
      const tick = Number(digit + 'e' + power);
      if (tick >= low && tick <= high) ticks.push(tick);
    }
  return ticks;
}

class LivePlot {
  constructor(figure, drawing, block) {
    const frame = drawing.querySelector('rect[data-axes]');
    const [xLow, xHigh, yLow, yHigh] = frame.dataset.axes.split(' ').map(Number);
    this.log = {x: frame.dataset.log.includes('x'), y: frame.dataset.log.includes('y')};
    const raised = (v, axis) => (this.log[axis] ? 10 ** v : v);
    this.whole = {x: [raised(xLow, 'x'), raised(xHigh, 'x')], y: [raised(yLow, 'y'), raised(yHigh, 'y')]};
    this.labels = {x: frame.dataset.x, y: frame.dataset.y};
    this.step = (yHigh - yLow) / 2000;
    this.xStep = (xHigh - xLow) / 2000;
    const {lines, bands, levels} = JSON.parse(block.textContent);
    Object.assign(this, {bands, levels});
    for (const line of lines) Object.assign(line, {x: floats(line.x), y: floats(line.y)});
    const tables = lines.map(alongX);
    this.lines = lines.filter((_, i) => tables[i]);
    this.strokes = lines.filter((_, i) => !tables[i]);  // bars and the like: drawn, without values
    const followed = tables.filter(t => t);

    const [, , width, height] = drawing.getAttribute('viewBox').split(' ').map(Number);
    this.shape = height / width;
    const title = drawing.getAttribute('aria-label');
    const live = figure.appendChild(made('div', {className: 'plot-live'}));
    live.append(made('div', {className: 'plot-title', textContent: title}));
    this.box = live.appendChild(made('div', {className: 'plot-box', tabIndex: 0}));
    this.box.setAttribute('role', 'application');
    this.box.setAttribute('aria-label',
      title + '. Left and right arrow tell the values, plus and minus zoom, 0 shows everything.');
    this.said = live.appendChild(made('div', {className: 'plot-said'}));
    this.said.setAttribute('aria-live', 'polite');
    this.figure = figure;
    this.width = figure.clientWidth;
    try {
      this.plot = new uPlot(this.options(), followed.length ? uPlot.join(followed) : [this.whole.x], this.box);
    } catch (error) {
      live.remove();
      throw error;
    }
    figure.classList.add('live');
    this.makeLegendKeys();
    this.box.addEventListener('keydown', e => this.key(e));
    new ResizeObserver(() => this.fit()).observe(figure);
    window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.plot.redraw(false));
  }

  options() {
    const axis = (name, size) => ({
      scale: name, label: this.labels[name], labelSize: 20, labelFont: '12px system-ui, sans-serif', size,
      font: '11px system-ui, sans-serif',
      stroke: () => colour('--text'), grid: {stroke: () => colour('--line'), width: 1}, ticks: {show: false},
      ...(name === 'x' ? {gap: 4} : {}),
      ...(this.log[name] ? {splits: (u, k, low, high) => logarithmicTicks(low, high), filter: (u, at) => at} : {}),
      values: (u, splits, k, space, step) => splits.map(v => (v == null ? '' : shown(v, step, this.log[name], true))),
    });
    return {
      ...this.size(), legend: {live: true}, drawOrder: ['axes', 'series'],
      scales: {
        x: {time: false, distr: this.log.x ? 3 : 1, range: (u, low, high) => this.rangeOfX(u, low, high)},
        y: {distr: this.log.y ? 3 : 1, range: (u, low, high) => this.rangeOfY(low, high)},
      },
      axes: [axis('x', 28), axis('y', 46)],
      series: [
        {label: this.labels.x, value: (u, v) => shown(v, this.xStep, this.log.x)},
        ...this.lines.map(line => ({
          label: line.name, class: line.name ? null : 'u-unnamed', scale: 'y',
          stroke: () => colour('--s' + line.source) + (line.faint ? '52' : ''), width: line.faint ? 0.8 : 1.7,
          dash: line.dashed ? [5, 3] : undefined, spanGaps: false,
          points: {show: line.points, size: 7, fill: () => colour('--s' + line.source)},
          value: (u, v) => shown(v, this.step, this.log.y),
        })),
      ],
      cursor: {
        ...(this.labels.x.startsWith('time') ? {sync: {key: 'time', setSeries: false}} : {}),  // one time in all of them
        y: false, drag: {x: true, y: false, dist: 5}, dataIdx: (u, series, at, x) => this.nearest(u, series, at, x),
        points: {size: (u, series) => (this.lines[series - 1].name ? 8 : 0)},
      },
      hooks: {
        drawAxes: [u => this.within(u, ctx => this.drawBands(u, ctx))],
        draw: [u => this.within(u, (ctx, bbox) => this.drawLevels(u, ctx, bbox))],
      },
    };
  }

  /** A click into the legend hides a curve; so do Enter and the space bar. */
  makeLegendKeys() {
    const rows = Array.from(this.box.querySelectorAll('.u-series')).slice(1);  // behind that of x
    rows.forEach((row, i) => {
      if (!this.lines[i].name) return;
      const name = row.querySelector('th');
      const tell = () => name.setAttribute('aria-checked', String(this.plot.series[i + 1].show));
      name.tabIndex = 0;
      name.setAttribute('role', 'switch');
      name.addEventListener('click', () => setTimeout(tell));
      name.addEventListener('keydown', e => {
        if (e.key !== 'Enter' && e.key !== ' ') return;
        e.preventDefault();
        name.click();
      });
      tell();
    });
  }

  // Title and legend stand in what the drawing takes: nothing moves when one takes the other's place.
  size() { return {width: this.width, height: Math.max(160, Math.round(this.shape * this.width) - 48)}; }
  fit() {
    if (this.figure.clientWidth === 0 || this.figure.clientWidth === this.width) return;  // on paper it is not there
    this.width = this.figure.clientWidth;
    this.plot.setSize(this.size());
  }

  rangeOfX(u, low, high) {
    const data = u.data[0];
    this.zoomed = low > data[0] || high < data[data.length - 1];
    return this.zoomed ? [low, high] : this.whole.x;
  }
  /** Of everything as the drawing has it, which leaves out start-up spikes; of a part, what is in it. */
  rangeOfY(low, high) {
    if (!this.zoomed || low == null || !(high >= low)) return this.whole.y;
    return this.log.y ? uPlot.rangeLog(low, high, 10, false) : uPlot.rangeNum(low, high, 0.1, false);
  }

  /** Number of the series' value nearest to the pointer; between its values lie the times of the other series. */
  nearest(u, series, at, x) {
    if (series === 0) return at;
    const values = u.data[series], times = u.data[0];
    let before = at, after = at;
    while (before >= 0 && values[before] === undefined) --before;
    while (after < values.length && values[after] === undefined) ++after;
    const found = before < 0 ? after : after >= values.length || x - times[before] < times[after] - x ? before : after;
    if (found < 0 || found >= values.length) return null;
    return Math.abs(u.valToPos(times[found], 'x') - u.valToPos(x, 'x')) <= reach ? found : null;
  }

  /** The canvas as it is, to be drawn into within the axes; afterwards it is restored. */
  within({ctx, bbox}, draw) {
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    draw(ctx, bbox);
    ctx.restore();
  }

  drawBands(u, ctx) {
    ctx.globalAlpha = 0.22;
    for (const b of this.bands) {
      const [left, right] = [b.from, b.to].map(v => u.valToPos(v, 'x', true));
      const [top, bottom] = [b.value + b.half_width, b.value - b.half_width].map(v => u.valToPos(v, 'y', true));
      ctx.fillStyle = colour('--s' + b.source);
      ctx.fillRect(left, Math.min(top, (top + bottom) / 2 - 0.5), Math.max(1, right - left), Math.max(1, bottom - top));
    }
  }

  drawLevels(u, ctx, bbox) {
    const dots = devicePixelRatio || 1;
    const stroke = (points, style, width, dash) => {
      ctx.strokeStyle = style;
      ctx.lineWidth = width * dots;
      ctx.setLineDash(dash.map(v => v * dots));
      ctx.beginPath();
      for (const [x, y] of points) ctx.lineTo(u.valToPos(x, 'x', true), u.valToPos(y, 'y', true));
      ctx.stroke();
    };
    for (const b of this.bands) stroke([[b.from, b.value], [b.to, b.value]], colour('--s' + b.source), 2.2, []);
    for (const line of this.strokes)
      stroke(Array.from(line.x, (x, i) => [x, line.y[i]]), colour('--s' + line.source), 1.7, line.dashed ? [5, 3] : []);
    ctx.fillStyle = colour('--soft');
    ctx.font = 11 * dots + 'px system-ui, sans-serif';
    ctx.textAlign = 'right';
    for (const level of this.levels) {
      const y = u.valToPos(level.value, 'y', true);
      stroke([[u.scales.x.min, level.value], [u.scales.x.max, level.value]], colour('--soft'), 1, [2, 3]);
      ctx.fillText(level.name, bbox.left + bbox.width - 6 * dots, y - 4 * dots);
    }
  }

  /** Shows the part around the cursor, `factor` times as large as now. */
  zoom(factor) {
    const u = this.plot, {min, max} = u.scales.x;
    const [logarithm, power] = this.log.x ? [Math.log10, v => 10 ** v] : [v => v, v => v];
    const [low, high] = [logarithm(min), logarithm(max)];
    const left = u.cursor.left >= 0 ? u.cursor.left : u.over.clientWidth / 2, share = left / u.over.clientWidth;
    const middle = low + share * (high - low), edge = factor * (high - low);
    const [first, last] = [this.whole.x[0], this.whole.x[1]].map(logarithm);
    if (edge < 1e-5 * (last - first)) return;
    if (edge >= last - first) this.reset();
    else {
      const from = Math.min(Math.max(middle - share * edge, first), last - edge);
      u.setScale('x', {min: power(from), max: power(from + edge)});
    }
  }
  reset() {
    const data = this.plot.data[0];
    this.plot.setScale('x', {min: data[0], max: data[data.length - 1]});
  }

  key(e) {
    if (e.ctrlKey || e.altKey || e.metaKey) return;
    const u = this.plot, width = u.over.clientWidth, turn = {ArrowLeft: -1, ArrowRight: 1}[e.key];
    if (turn) {
      const from = u.cursor.left >= 0 ? u.cursor.left : turn > 0 ? 0 : width;
      const left = Math.min(width, Math.max(0, from + turn * width * (e.shiftKey ? 0.1 : 0.01)));
      u.setCursor({left, top: u.over.clientHeight / 2});
      this.said.textContent = this.values();
    } else if (e.key === '+' || e.key === '=') this.zoom(0.5);
    else if (e.key === '-') this.zoom(2);
    else if (e.key === '0') this.reset();
    else return;
    e.preventDefault();
  }
  /** What the legend shows at the cursor, in words. */
  values() {
    const u = this.plot, told = [this.labels.x + ': ' + shown(u.posToVal(u.cursor.left, 'x'), this.xStep, this.log.x)];
    this.lines.forEach((line, i) => {
      const at = u.cursor.idxs[i + 1];
      if (line.name && at != null) told.push(line.name + ': ' + shown(u.data[i + 1][at], this.step, this.log.y));
    });
    return told.concat(this.labels.y).join(', ');
  }
}

// Each is made when it comes near the screen, after the page has been shown, and one after the other so that the page
// answers in between.
const near = new IntersectionObserver(entries => {
  for (const {isIntersecting, target} of entries) {
    if (!isIntersecting) continue;
    near.unobserve(target);
    setTimeout(() => new LivePlot(target, target.querySelector('svg.plot'), target.querySelector('.plot-data')));
  }
}, {rootMargin: '600px 0px'});
for (const block of document.querySelectorAll('.plot-data')) near.observe(block.closest('figure'));
