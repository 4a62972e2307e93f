'use strict';
// How both teams played: the ball's time, figures of each team, and all shots.

const playFigures = new Map(match.play.map((figure) => [figure.name, figure]));

/** What the ball's time is spent on, in the order of its shares on the page. */
const ballUses = {
  comes: 'lies free, somebody comes',
  rolls: 'rolls, nobody near',
  linedUp: 'at a robot that lines up',
  kicked: 'a kick is performed',
  pushed: 'rolls among robots',
  duel: 'both teams line up',
  goalie: 'beside a goalie',
  searched: 'beside a robot that searches it',
  left: 'lies free, nobody comes'
};

/** The rows of the table of both teams: the name of a figure without its team, and words for it. */
const playRows = [
  ['possession', 'touched the ball last, % of the time'],
  ['territory', 'ball in the opponents’ half, % of the time'],
  ['kicks', 'kicks in a minute'],
  ['kick.afterTouch.median', 'from another robot’s touch to the kick, median, s'],
  ['kick.afterTouch.rolls.mean', 'of that the ball rolls, mean, s'],
  ['kick.afterTouch.comes.mean', 'of that somebody comes, mean, s'],
  ['kick.afterTouch.linesUp.mean', 'of that it is lined up, mean, s'],
  ['kick.hits', 'kicks that hit, %'],
  ['kick.way.median', 'how far the ball goes, median, mm'],
  ['kick.back', 'kicks that go backward, %'],
  ['kick.nextTouch.own', 'next touch by the own team, %'],
  ['kick.pass', 'next touch by a teammate, %'],
  ['kick.onGoal', 'kicks from within 1.6 m that go on goal, %'],
  ['shots', 'balls that rolled to the goal'],
  ['goalie.acts', 'of the opponents’ ones, met by a block, %'],
  ['goalie.moved.median', 'goalie’s way meanwhile, median, mm'],
  ['letIn.shot', 'goals let in by a shot'],
  ['letIn.beside', 'goals let in, ball lay beside the goalie'],
  ['letIn.touched', 'goals let in, pushed in by the goalie'],
  ['striker.speed', 'striker far from the ball, mm/s'],
  ['striker.unseen', 'striker does not see the ball, % of the time'],
  ['strikers.two', 'more than one striker, % of the time'],
  ['strikers.none', 'no striker, % of the time'],
  ['ownArea', 'field players in the own penalty area, s in 5 min'],
  ['penalties', 'penalties in 5 min']
];

const penaltyRows = match.play.filter((figure) => figure.value > 0)
                        .map((figure) => figure.name.match(/^(?:red|blue)\.(penalties\.(\w+))$/))
                        .filter((found) => found)
                        .map((found) => [found[1], `of these for ${wordOf(found[2])}`]);

function showBallShares() {
  for (const [use, words] of Object.entries(ballUses)) {
    const share = playFigures.get('ball.' + use).value;
    byId('ballShares')
        .append(
            element('span', {text: words}),
            element(
                'span', {class: 'bar'},
                element('span', {style: `width: ${share.toFixed(1)}%`})),
            element('span', {class: 'value', text: number(share, 1) + '\u00a0%'}));
  }
}

function showPlay() {
  const valueOf = (team, name) => {
    const figure = playFigures.get(`${team}.${name}`);
    if (!figure) return '–';
    return number(figure.value, Math.abs(figure.value) < 10 && figure.value % 1 ? 1 : 0);
  };
  const rows = [...playRows, ...new Map(penaltyRows)].filter(
      ([name]) => ['red', 'blue'].some((team) => playFigures.has(`${team}.${name}`)));
  fillTable(
      byId('playTable'), 'How both teams played', [{name: 'figure'}, {name: 'Red'}, {name: 'Blue'}],
      rows.map(([name, words]) => [words, valueOf('red', name), valueOf('blue', name)]));
}

function showShots() {
  const ends = {
    goal: 'goal',
    saved: 'touched by the goalie',
    stopped: 'stopped by another robot',
    missed: 'did not arrive'
  };
  byId('shotDetails').hidden = match.shots.length === 0;
  const head = ['time', 'shot by', 'from (x, y), mm', 'mm/s', 'goalie moved, mm', 'goalie did', 'end']
                   .map((name, i) => ({name, text: i === 1 || i > 4}));
  fillTable(byId('shotTable'), 'All shots', head, match.shots.map((shot) => [
    clock(shot.time / 1000), shot.robot < 0 ? teamName(shot.team) : robotName(robots[shot.robot]),
    `${number(shot.origin.x)}, ${number(shot.origin.y)}`, number(shot.speed),
    number(shot.goalieMoved), shot.goalieAction || '–', ends[shot.end]
  ]));
}

byId('playSection').hidden = !playFigures.has('ball.comes');
if (!byId('playSection').hidden) {
  showBallShares();
  showPlay();
  showShots();
}
