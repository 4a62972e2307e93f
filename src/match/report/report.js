'use strict';
// What every part of the page needs, and the parts that are words and tables.

const page = JSON.parse(document.getElementById('data').textContent);
const {match, times, field} = page;
const robots = match.robots;
const aims = {
  median: 150,
  percentile95: 600
};
const seconds = match.duration / 1000;
const changeOfColors = [];  // called when colors change: light, dark, paper

const byId = (id) => document.getElementById(id);
const colorOf = (name) =>
    getComputedStyle(document.documentElement).getPropertyValue('--' + name).trim();
const colorNameOf = (robot) => robot.team + Math.min(Math.max(robot.player, 1), 4);
const teamName = (team) => (team === 'red' ? 'Red' : 'Blue');
const robotName = (robot) => `${teamName(robot.team)} ${robot.player}`;
const clock = (s) => `${Math.floor(s / 60)}:${String(Math.floor(s % 60)).padStart(2, '0')}`;
const number = (value, digits = 0) => value === null || !Number.isFinite(value) ?
    '–' :
    value.toLocaleString('en', {minimumFractionDigits: digits, maximumFractionDigits: digits});
const sum = (list) => list.reduce((a, b) => a + b, 0);
const kicksOf = (robot) => sum(robot.kicks.map((kick) => kick.count));

/** Makes an element: its attributes (class, text, on... as a function), then its children. */
function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes))
    if (name === 'text')
      node.textContent = value;
    else if (typeof value === 'function')
      node.addEventListener(name.slice(2), value);
    else
      node.setAttribute(name, value);
  node.append(...children);
  return node;
}

function quantile(values, share) {
  const sorted = values.filter((v) => v !== null).sort((a, b) => a - b);
  return sorted.length ? sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * share))] :
                         null;
}

/** The events with the side that each goal counts for: the one whose score it changed. */
function eventsWithSides() {
  let red = 0, blue = 0;
  return match.events.map((event) => {
    const side = event.redScore > red ? 'red' : event.blueScore > blue ? 'blue' : event.team;
    red = event.redScore;
    blue = event.blueScore;
    const shooter = event.ownGoal ? (side === 'red' ? 'blue' : 'red') : side;
    return {...event, side, shooter, second: event.time / 1000};
  });
}
const events = eventsWithSides();
const goals = events.filter((event) => event.kind === 'goal');
const words = {
  kickOff: 'kick-off',
  halfTime: 'half time',
  stuckBall: 'stuck ball',
  ballOut: 'ball out',
  placedRobot: 'robot placed',
  gameOver: 'end'
};
const wordOf = (kind) => words[kind] || kind.replace(/([A-Z])/g, ' $1').toLowerCase();

function showScore() {
  byId('redScore').textContent = match.redScore;
  byId('blueScore').textContent = match.blueScore;
  for (const goal of goals) {
    const who = goal.player > 0 ? `${teamName(goal.shooter)} ${goal.player}` : teamName(goal.side);
    byId(goal.side + 'Scorers').append(element('li', {
      text: `${clock(goal.second)} ${who}${goal.ownGoal ? ' (own goal)' : ''}`
    }));
  }
  const perTeam = (team) => robots.filter((robot) => robot.team === team).length;
  byId('subtitle').textContent = [
    `${perTeam('red')} : ${perTeam('blue')} robots`,
    match.interrupted ? `interrupted at ${clock(seconds)}` : `${clock(seconds)} minutes`,
    match.scene, `seed ${match.seed}`, `${number(times.realTimeFactor, 1)} × real time`
  ].join(' · ');
  const failures = events.filter((event) => event.kind === 'failure');
  byId('failures').hidden = failures.length === 0;
  byId('failures').textContent =
      failures.map((event) => `${clock(event.second)} ${event.text}`).join('; ');
  byId('broken').hidden = match.broken.length === 0;
  byId('broken').textContent = match.broken
                                   .map((b) => `${clock(b.time / 1000)} ${b.severity}: ` +
                                        `${b.invariant}: ${b.who}: ${b.text}`)
                                   .join('; ');
  byId('truth').hidden = match.truth.length === 0;
  byId('truth').textContent = `Given the truth by the simulator: ${match.truth.join(', ')}`;
}

function showFigures() {
  const errors = robots.flatMap((robot) => robot.samples.error);
  const figure = (name, value, unit, aim) => {
    const box = element(
        'div', {}, element('dt', {text: name}),
        element('dd', {text: value}, element('small', {text: unit ? ' ' + unit : ''})));
    if (aim)
      box.append(element('span', {
        class: 'aim ' + (aim.met ? 'met' : 'missed'),
        text: `${aim.met ? '✓' : '✗'} aim ${aim.text}`
      }));
    byId('figures').append(box);
  };
  const median = quantile(errors, .5), percentile95 = quantile(errors, .95);
  figure(
      'localization error, median', number(median), 'mm',
      median !== null && {met: median <= aims.median, text: '≤ 150\u00a0mm'});
  figure(
      'localization error, 95\u00a0%', number(percentile95), 'mm',
      percentile95 !== null && {met: percentile95 <= aims.percentile95, text: '≤ 600\u00a0mm'});
  figure(
      'goals, own goals',
      `${goals.filter((g) => !g.ownGoal).length} + ${goals.filter((g) => g.ownGoal).length}`);
  figure('kicks', number(sum(robots.map(kicksOf))));
  figure('walked by all', number(sum(robots.map((robot) => robot.distanceWalked)) / 1000), 'm');
  figure('falls', number(sum(robots.map((robot) => robot.falls))));
  figure('faster than real time', number(times.realTimeFactor, 1), '×');
}

function fillTable(table, caption, head, rows) {
  const cell = (tag, content, attributes) => content instanceof Node ?
      element(tag, attributes, content) :
      element(tag, {...attributes, text: content});
  table.setAttribute('aria-label', caption);
  table.append(element(
      'thead', {},
      element(
          'tr', {},
          ...head.map(
              (h, i) => element(
                  'th', {scope: 'col', class: i === 0 || h.text ? 'text' : '', text: h.name})))));
  table.append(element(
      'tbody', {},
      ...rows.map(
          (row) => element(
              'tr', {},
              ...row.map(
                  (content, i) => i === 0 ?
                      cell('th', content, {scope: 'row'}) :
                      cell('td', content, {class: head[i].text ? 'text' : ''}))))));
}

function showRobots() {
  const judged = (value, aim) => value === null ? '–' : element('span', {
    class: value <= aim ? 'met' : 'missed',
    text: `${number(value)} ${value <= aim ? '✓' : '✗'}`
  });
  const degrees = (angle) => angle === null ? '–' : number(angle * 180 / Math.PI, 1) + '°';
  const has = (statistics) => statistics.count > 0;
  const head = [
    'robot', 'role', 'position error, median, mm', '95\u00a0%, mm', 'rotation error, median',
    '95\u00a0%', 'ball error, median, mm', '95\u00a0%, mm', 'walked, m', 'kicks', 'falls', 'goals',
    'own goals'
  ].map((name, i) => ({name, text: i === 1}));
  fillTable(byId('robotTable'), 'Figures of each robot', head, robots.map((robot) => {
    const {localizationError: l, rotationError: r, ballError: b} = robot;
    const kicks = element('span', {
      text: number(kicksOf(robot)),
      title: robot.kicks.map((k) => `${k.kick}: ${k.count}`).join(', ')
    });
    return [
      element(
          'span', {title: robot.name, style: `--color: var(--${colorNameOf(robot)})`},
          element('span', {class: 'dot'}), robotName(robot)),
      robot.role, has(l) ? judged(l.median, aims.median) : '–',
      has(l) ? judged(l.percentile95, aims.percentile95) : '–', has(r) ? degrees(r.median) : '–',
      has(r) ? degrees(r.percentile95) : '–', has(b) ? number(b.median) : '–',
      has(b) ? number(b.percentile95) : '–', number(robot.distanceWalked / 1000, 1), kicks,
      number(robot.falls), number(robot.goals), number(robot.ownGoals)
    ];
  }));
}

function showPictures() {
  if (page.pictures.length === 0) byId('pictureSection').hidden = true;
  const box = byId('lightbox');
  box.addEventListener('click', () => box.close());
  for (const picture of page.pictures) {
    const image = () => element('img', {
      src: picture.source,
      alt: `Camera picture with percepts: ${picture.title}`,
      width: picture.width,
      height: picture.height
    });
    const enlarge = () => {
      box.replaceChildren(
          element('figure', {}, image(), element('figcaption', {text: picture.title})),
          element('button', {text: 'Close', onclick: () => box.close()}));
      box.showModal();
    };
    byId('gallery').append(element(
        'figure', {}, element('button', {onclick: enlarge, title: 'Enlarge'}, image()),
        element('figcaption', {text: picture.title})));
  }
}

function showRun() {
  const minutes = Number((seconds / 60).toFixed(3));
  const facts = {
    'Scene': match.scene,
    'Seed': match.seed,
    'Duration': `${clock(seconds)} minutes of simulated time${
        match.interrupted ? ', then it was interrupted' : ''}`,
    'Computing time':
        `${number(times.seconds, 1)} s, ${number(times.realTimeFactor, 1)} × real time`,
    'Threads': times.threads,
    'Logs': robots.map((robot) => robot.log).filter((log) => log).join(', ') || 'none',
  };
  for (const [name, value] of Object.entries(facts))
    byId('facts').append(element('dt', {text: name}), element('dd', {text: value}));
  byId('again').hidden = match.interrupted;  // nobody knows how long it should have been
  byId('command').textContent = `simgt play ${match.scene} --minutes ${minutes} --seed ${
      match.seed} --threads ${times.threads} --out out/again`;
}

showScore();
showFigures();
showRobots();
showPictures();
showRun();

const recolor = () => changeOfColors.forEach((change) => change());
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', recolor);
for (const [event, printing] of [['beforeprint', true], ['afterprint', false]])
  addEventListener(event, () => {
    document.documentElement.classList.toggle('printing', printing);
    recolor();
  });
