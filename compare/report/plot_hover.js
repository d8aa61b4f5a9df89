// Values of the curves under the pointer, in every plot of the page. They are read from the drawing itself: each frame
// gives its axes (data-axes: low and high of x and y; data-log: which of them are logarithmic; data-x, data-y: labels),
// each curve with a name gives it in data-name. Without this script the plots stay what they are.
(function () {
  'use strict';

  const made = (name, attributes) => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', name);
    for (const key in attributes) element.setAttribute(key, attributes[key]);
    return element;
  };
  const tip = document.createElement('div');
  tip.id = 'hover-values';
  tip.hidden = true;
  tip.setAttribute('aria-hidden', 'true');
  document.body.append(tip);

  /** Points of a path that has only M and L, in the drawing's units. */
  const pointsOf = path => path.getAttribute('d').split(/[ML]/).slice(1).map(pair => pair.split(',').map(Number));

  /** Place along an axis, 0 to 1, as a number with the digits that the drawing resolves. */
  function valueAt(share, low, high, logarithmic, pixels) {
    const at = low + share * (high - low), step = (high - low) / (2 * pixels);
    if (logarithmic) return Number((10 ** at).toPrecision(3)).toString();
    const places = Math.min(8, Math.max(0, Math.ceil(-Math.log10(step))));
    return at.toFixed(places).replace(/^-(?=0(\.0*)?$)/, '').replace('-', '−');
  }

  function plotOf(frame) {
    const number = name => Number(frame.getAttribute(name));
    const box = {x: number('x'), y: number('y'), width: number('width'), height: number('height')};
    const [xLow, xHigh, yLow, yHigh] = frame.dataset.axes.split(' ').map(Number);
    const logX = frame.dataset.log.includes('x'), logY = frame.dataset.log.includes('y');
    const inside = frame.previousElementSibling;  // the nested <svg> that clips the curves
    const curves = Array.from(inside.querySelectorAll('path[data-name]'), path => ({
      name: path.dataset.name,
      colour: Array.from(path.classList).find(c => /^s\d$/.test(c)),
      points: pointsOf(path),
    }));
    const rule = made('line', {class: 'level', y1: box.y, y2: box.y + box.height, visibility: 'hidden'});
    inside.append(rule);
    const dots = curves.map(curve => {
      const dot = made('circle', {class: 'f' + curve.colour.slice(1), r: 4, visibility: 'hidden'});
      inside.append(dot);
      return dot;
    });

    function hide() {
      for (const mark of [rule, ...dots]) mark.setAttribute('visibility', 'hidden');
    }
    /** The lines of the note at this place of the screen; null: the pointer is elsewhere. */
    function show(clientX, clientY) {
      const p = new DOMPoint(clientX, clientY).matrixTransform(frame.getScreenCTM().inverse());
      if (p.x < box.x || p.x > box.x + box.width || p.y < box.y || p.y > box.y + box.height) return null;
      const nearest = curves.map(curve => {
        let best = null;
        for (const point of curve.points)
          if (!best || Math.abs(point[0] - p.x) < Math.abs(best[0] - p.x)) best = point;
        return best && Math.abs(best[0] - p.x) < 20 ? best : null;
      });
      const shown = nearest.filter(point => point);
      if (shown.length === 0) return null;
      const x = shown.reduce((a, b) => (Math.abs(a[0] - p.x) <= Math.abs(b[0] - p.x) ? a : b))[0];
      rule.setAttribute('x1', x);
      rule.setAttribute('x2', x);
      rule.setAttribute('visibility', 'visible');
      const lines = [frame.dataset.x + ': ' + valueAt((x - box.x) / box.width, xLow, xHigh, logX, box.width)];
      nearest.forEach((point, k) => {
        dots[k].setAttribute('visibility', point ? 'visible' : 'hidden');
        if (!point) return;
        dots[k].setAttribute('cx', point[0]);
        dots[k].setAttribute('cy', point[1]);
        const share = (box.y + box.height - point[1]) / box.height;
        lines.push(curves[k].name + ': ' + valueAt(share, yLow, yHigh, logY, box.height));
      });
      lines.push(frame.dataset.y);
      return lines;
    }
    return {show, hide, empty: curves.length === 0};
  }

  for (const drawing of document.querySelectorAll('svg.plot')) {
    let plots = null;  // made when the pointer first comes
    const hide = () => {
      tip.hidden = true;
      if (plots) for (const plot of plots) plot.hide();
    };
    drawing.addEventListener('pointermove', event => {
      if (!plots)
        plots = Array.from(drawing.querySelectorAll('rect[data-axes]'), plotOf).filter(plot => !plot.empty);
      hide();
      for (const plot of plots) {
        const lines = plot.show(event.clientX, event.clientY);
        if (!lines) continue;
        tip.textContent = lines.join('\n');
        tip.hidden = false;
        const left = event.clientX + 16 + tip.offsetWidth > innerWidth ? event.clientX - 16 - tip.offsetWidth : event.clientX + 16;
        tip.style.left = left + 'px';
        tip.style.top = Math.min(event.clientY + 12, innerHeight - tip.offsetHeight - 4) + 'px';
      }
    });
    drawing.addEventListener('pointerleave', hide);
  }
})();
