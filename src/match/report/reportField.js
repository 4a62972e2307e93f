'use strict';
// The time line of events, and the field with the traces of ball and robots.

const lastSecond = Math.max(1, Math.ceil(seconds));
const selection = {
  from: 0,
  to: lastSecond,
  hidden: new Set()
};
const changeOfSelection = [];  // called when the selected time changes

const isOfMatch = (kind) => ['halfTime', 'gameOver', 'end'].includes(kind);
const isOfTeam = (kind) => ['goal', 'kickOff'].includes(kind);

/** Selects a time and has everything that depends on it drawn anew. */
function select(from, to) {
  selection.from = Math.max(0, Math.min(from, lastSecond));
  selection.to = Math.max(selection.from, Math.min(to, lastSecond));
  changeOfSelection.forEach((change) => change());
}

function describe(event) { return `${clock(event.second)}  ${event.text || wordOf(event.kind)}`; }

function showTimeline() {
  const line = byId('timeline'), text = byId('eventText');
  const place = (second) => `left: ${(100 * second / lastSecond).toFixed(3)}%`;
  const choose = (event, node) => {
    stop();
    line.querySelectorAll('.chosen').forEach((other) => other.classList.remove('chosen'));
    if (node) node.classList.add('chosen');
    text.textContent = describe(event);
    select(event.second - 15, event.second + (event.kind === 'goal' ? 0 : 5));
  };
  const marks = events.filter((event) => event.kind !== 'kick').map((event) => {
    const kind = isOfMatch(event.kind) ? 'part' :
        isOfTeam(event.kind)           ? `${event.kind} ${event.side}` :
                                         'other';
    const node = element('button', {
      class: 'event ' + kind,
      style: place(event.second),
      title: describe(event),
      'aria-label': describe(event),
      text: event.kind === 'goal' ? `${event.redScore}:${event.blueScore}` : '',
      onclick: () => choose(event, node),
      onmouseenter: () => {
        text.textContent = describe(event);
      },
      onfocus: () => {
        text.textContent = describe(event);
      },
    });
    return node;
  });
  const step = [15, 30, 60, 120, 300, 600, 1800].find((s) => lastSecond / s <= 10) || 3600;
  const ticks = [];
  for (let second = 0; second <= lastSecond; second += step)
    ticks.push(element('span', {class: 'tick', style: place(second), text: clock(second)}));
  line.append(...ticks, ...marks);
  line.after(element(
      'p', {class: 'legend'},
      ...['● with score: goal, above for red, below for blue', '❙ kick-off',
          '◇ stuck ball and others', '| half time and end']
          .map((name) => element('span', {text: name}))));
  fillTable(
      byId('eventTable'), 'Events',
      [{name: 'time'}, {name: 'event', text: true}, {name: 'score'}, {name: '', text: true}],
      events.map(
          (event) =>
              [element('button', {
                 text: clock(event.second),
                 title: 'Show on the field',
                 onclick: () => choose(event)
               }),
               wordOf(event.kind), `${event.redScore}:${event.blueScore}`, event.text]));
}

/** Makes an element of the drawing. */
function shape(tag, attributes, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

/** The corners of the field inside its walls, counterclockwise (mm). */
function fieldCorners() {
  const quarter = [
    [field.xGoalBack, field.yGoal], [field.xGroundline, field.yGoal],
    [field.xGroundline, field.ySideCorner], [field.xSideCorner, field.ySideline]
  ];
  const mirror = (points, sx, sy) => points.map(([x, y]) => [sx * x, sy * y]);
  return [
    ...quarter, ...mirror(quarter, -1, 1).reverse(), ...mirror(quarter, -1, -1),
    ...mirror(quarter, 1, -1).reverse()
  ];
}

function drawGround() {
  const {xGroundline: xg, xPenaltyArea: xp, yPenaltyArea: yp, xGoalBack: xb, yGoal, lineWidth} =
      field;
  const outline = fieldCorners().map((p) => p.join(',')).join(' ');
  const line = (d) =>
      shape('path', {d, fill: 'none', stroke: '#fff', 'stroke-width': lineWidth, opacity: .85});
  const flag = (x, y, lower, upper) => shape(
      'g', {},
      shape(
          'circle',
          {cx: x, cy: y, r: field.flagRadius, fill: lower, stroke: '#fff', 'stroke-width': 12}),
      shape('circle', {cx: x, cy: y, r: field.flagRadius * .5, fill: upper}));
  const ground = shape(
      'g', {}, shape('polygon', {
        points: outline,
        fill: '#1d5b38',
        stroke: '#e9ece9',
        'stroke-width': 70,
        'stroke-linejoin': 'round'
      }),
      shape('polygon', {points: outline, fill: '#1d5b38'}));
  for (const [side, color] of [[-1, '#f1d01b'], [1, '#58b9f2']]) {
    ground.append(
        shape('rect', {
          x: side < 0 ? -xb : xg,
          y: -yGoal,
          width: xb - xg,
          height: 2 * yGoal,
          fill: color,
          opacity: .35
        }),
        shape('path', {
          d: `M${side * xg} ${yGoal}H${side * xb}V${- yGoal}H${side * xg}`,
          fill: 'none',
          stroke: color,
          'stroke-width': 40
        }),
        line(`M${side * xg} ${yp}H${side * xp}V${- yp}H${side * xg}`),
        line(`M${side * xg} ${- yGoal}V${yGoal}`));
    ground.append(...[-1, 1].map(
        (y) => flag(
            side * field.flagX, y * field.flagY, y < 0 ? color : '#f0539e',
            y < 0 ? '#f0539e' : color)));
  }
  ground.append(
      line(`M0 ${- field.ySideline}V${field.ySideline}`), shape('circle', {
        r: field.centerCircleRadius,
        fill: 'none',
        stroke: '#fff',
        'stroke-width': lineWidth,
        opacity: .85
      }),
      flag(0, -field.flagY, '#12a150', '#f0539e'), flag(0, field.flagY, '#f0539e', '#12a150'));
  return ground;
}

/** A column of samples at any time: between two samples in a straight line. */
function valueAt(column, second) {
  const at = Math.min(second / page.sampleSeconds, column.length - 1), i = Math.floor(at);
  const next = column[Math.min(i + 1, column.length - 1)];
  return column[i] === null || next === null ? column[i] :
                                               column[i] + (next - column[i]) * (at - i);
}

/** A trace of samples as a path; it breaks where `jumps` says that something was put by hand. */
function pathOf({x, y}, from, to, jumps) {
  const first = Math.ceil(from / page.sampleSeconds),
        last = Math.min(Math.floor(to / page.sampleSeconds), x.length - 1);
  let path = '', broken = true;
  for (let i = first; i <= last; ++i) {
    if (x[i] === null || y[i] === null) {
      broken = true;
      continue;
    }
    path += (broken || jumps(i) ? 'M' : 'L') + x[i] + ' ' + y[i];
    broken = false;
  }
  const end = [valueAt(x, to), valueAt(y, to)];
  return path && !end.includes(null) ? `${path}L${end.map(Math.round).join(' ')}` : path;
}

function robotTrace(robot) {
  const samples = robot.samples, color = `var(--${colorNameOf(robot)})`;
  const trace = shape('path', {class: 'trace', style: `--color: ${color}`});
  const seam = robot.team === 'red' ?
      '#c4121f' :
      '#1746b8';  // whatever its own color, the team is plain to see
  const body = shape(
      'g', {}, shape('rect', {
        x: -150,
        y: -80,
        width: 260,
        height: 160,
        rx: 50,
        fill: color,
        stroke: seam,
        'stroke-width': 24
      }),
      shape('circle', {cx: 120, cy: 0, r: 52, fill: color, stroke: seam, 'stroke-width': 24}));
  const label = shape(
      'text',
      {'text-anchor': 'middle', 'font-size': 130, 'font-weight': 700, fill: '#10261a', dy: 46});
  label.textContent = robot.player;
  const marker = shape('g', {}, body, label);
  const jumps = (i) => i > 0 &&
      Math.hypot(samples.x[i] - samples.x[i - 1], samples.y[i] - samples.y[i - 1]) >
          500 * page.sampleSeconds;
  const draw = (from, to, opacity) => {
    trace.setAttribute('d', pathOf(samples, from, to, jumps));
    trace.setAttribute('opacity', opacity);
    const i = Math.min(Math.floor(to / page.sampleSeconds), samples.x.length - 1);
    const next = Math.min(i + 1, samples.x.length - 1);
    const turn =
        ((samples.rotation[next] - samples.rotation[i]) / 100 + 3 * Math.PI) % (2 * Math.PI) -
        Math.PI;
    const angle = samples.rotation[i] / 100 +
        turn * (to / page.sampleSeconds - Math.floor(to / page.sampleSeconds));
    const [x, y] = [valueAt(samples.x, to), valueAt(samples.y, to)];
    marker.setAttribute('visibility', x === null || y === null ? 'hidden' : 'visible');
    const place = `translate(${x || 0} ${y || 0})`;
    body.setAttribute('transform', `${place} rotate(${angle * 180 / Math.PI})`);
    label.setAttribute('transform', `${place} scale(1 -1)`);
  };
  return {key: robotName(robot), color, nodes: [trace, marker], draw};
}

function ballTrace() {
  const trace = shape('path', {class: 'trace ball', style: '--color: #ffa531'});
  const dot = shape(
      'circle',
      {r: Math.max(field.ballRadius, 43), fill: '#ff8a00', stroke: '#10261a', 'stroke-width': 14});
  const moved = new Set(events.filter((event) => event.kind !== 'kick').flatMap((event) => {
    const i = Math.floor(event.second / page.sampleSeconds);
    return [i, i + 1];
  }));
  const jumps = (i) => i > 0 && moved.has(i) &&
      Math.hypot(match.ball.x[i] - match.ball.x[i - 1], match.ball.y[i] - match.ball.y[i - 1]) >
          300;
  const draw = (from, to, opacity) => {
    trace.setAttribute('d', pathOf(match.ball, from, to, jumps));
    trace.setAttribute('opacity', Math.max(opacity, .6));
    dot.setAttribute('cx', valueAt(match.ball.x, to) || 0);
    dot.setAttribute('cy', valueAt(match.ball.y, to) || 0);
  };
  return {key: 'Ball', color: '#f08a00', nodes: [trace, dot], draw};
}

function showField() {
  const svg = byId('field'), margin = 110;
  const wide = field.xGoalBack + margin, high = Math.max(field.ySideline, field.flagY) + margin;
  svg.setAttribute('viewBox', `${- wide} ${- high} ${2 * wide} ${2 * high}`);
  const up = shape('g', {transform: 'scale(1 -1)'}, drawGround());
  const traces = robots.filter((robot) => robot.samples.x.length > 0).map(robotTrace);
  if (match.ball.x.length > 0) traces.push(ballTrace());
  for (const layer of [0, 1]) up.append(...traces.map((trace) => trace.nodes[layer]));
  svg.append(up);
  for (const trace of traces) {
    const chip = element(
        'button', {
          'aria-pressed': 'true',
          style: `--color: ${trace.color}`,
          onclick: () => {
            const show = !selection.hidden.delete(trace.key);
            if (show) selection.hidden.add(trace.key);
            chip.setAttribute('aria-pressed', String(!show));
            trace.nodes.forEach((node) => {
              node.style.display = show ? 'none' : '';
            });
          }
        },
        element('span', {class: 'dot'}), trace.key);
    byId('traceChips').append(chip);
  }
  changeOfSelection.push(() => {
    const opacity = selection.to - selection.from > 120 ? .35 : .95;
    traces.forEach((trace) => trace.draw(selection.from, selection.to, opacity));
  });
}

function showRange() {
  const from = byId('rangeFrom'), to = byId('rangeTo');
  for (const input of [from, to]) {
    Object.assign(input, {min: 0, max: lastSecond, step: 1});
    input.addEventListener('input', () => {
      stop();
      if (Number(from.value) > Number(to.value)) (input === from ? to : from).value = input.value;
      select(Number(from.value), Number(to.value));
    });
  }
  changeOfSelection.push(() => {
    from.value = selection.from;
    to.value = selection.to;
    // At the right end the left thumb would be buried under the other.
    from.style.zIndex = selection.from > lastSecond * .9 ? 2 : 0;
    byId('rangeFill').style.left = `${100 * selection.from / lastSecond}%`;
    byId('rangeFill').style.right = `${100 - 100 * selection.to / lastSecond}%`;
    byId('rangeText').textContent = `${clock(selection.from)} – ${clock(selection.to)}`;
  });
  const half = events.find((event) => event.kind === 'halfTime');
  const choices = [['Whole match', 0, lastSecond]];
  if (half) choices.push(['First half', 0, half.second], ['Second half', half.second, lastSecond]);
  for (const goal of goals)
    choices.push([`Goal ${goal.redScore}:${goal.blueScore}`, goal.second - 15, goal.second]);
  byId('rangeButtons').append(playButton, ...choices.map(([name, a, b]) => element('button', {
                                                           text: name,
                                                           onclick: () => {
                                                             stop();
                                                             select(a, b);
                                                           }
                                                         })));
}

// Playing: ten times as fast as the match was, with traces of ten seconds.
const playSpeed = 10, playTrace = 10;
let playing = 0;
const playButton = element('button', {
  text: '▶ Play',
  title: `${playSpeed} times as fast`,
  onclick: () => (playing ? stop() : play())
});

function stop() {
  cancelAnimationFrame(playing);
  playing = 0;
  playButton.textContent = '▶ Play';
}

function play() {
  let now = selection.to >= lastSecond ? selection.from : selection.to, before = performance.now();
  playButton.textContent = '❚❚ Pause';
  const step = (time) => {
    now += Math.max(0, time - before) / 1000 * playSpeed;
    before = time;
    select(now - playTrace, now);
    if (now < lastSecond)
      playing = requestAnimationFrame(step);
    else
      stop();
  };
  playing = requestAnimationFrame(step);
}

showTimeline();
showField();
showRange();
select(0, lastSecond);
