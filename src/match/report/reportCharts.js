'use strict';
// The plots: localization error over time, and computing time of each part.

Chart.defaults.animation = false;
Chart.defaults.maintainAspectRatio = false;
Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
const dashes = [[], [7, 3], [2, 3], [9, 3, 2, 3]];  // by player: colors alone do not tell enough

function applyColors() {
  Chart.defaults.color = colorOf('soft');
  Chart.defaults.borderColor = colorOf('line');
}

/** Marks the goals and the time that is selected on the field. */
const matchMarks = {
  id: 'matchMarks',
  beforeDatasetsDraw(chart) {
    const {ctx, chartArea: area, scales: {x}} = chart;
    ctx.save();
    if (selection.to - selection.from < lastSecond - 1) {
      ctx.fillStyle = colorOf('accent') + '2e';
      const left = x.getPixelForValue(selection.from), right = x.getPixelForValue(selection.to);
      ctx.fillRect(left, area.top, Math.max(2, right - left), area.height);
    }
    ctx.setLineDash([3, 3]);
    for (const goal of goals) {
      const at = x.getPixelForValue(goal.second);
      ctx.strokeStyle = colorOf(goal.side);
      ctx.beginPath();
      ctx.moveTo(at, area.top);
      ctx.lineTo(at, area.bottom);
      ctx.stroke();
    }
    ctx.restore();
  },
};

/** The medians of so many samples each, as points of a plot. */
function smoothed(column, length) {
  const points = [];
  for (let i = 0; i < column.length; i += length) {
    const part = column.slice(i, i + length);
    points.push({x: (i + (part.length - 1) / 2) * page.sampleSeconds, y: quantile(part, .5)});
  }
  return points;
}

function errorData(length) {
  const lines = robots.map((robot) => ({
                             label: robotName(robot),
                             data: smoothed(robot.samples.error, length),
                             colorName: colorNameOf(robot),
                             borderWidth: 1.8,
                             borderDash: dashes[(robot.player + 3) % 4],
                             pointRadius: 0,
                             pointHitRadius: 6,
                           }));
  const aimLines = [
    ['aim, median: 150 mm', aims.median, []], ['aim, 95 %: 600 mm', aims.percentile95, [4, 4]]
  ].map(([label, y, borderDash]) => ({
          label,
          data: [{x: 0, y}, {x: lastSecond, y}],
          colorName: 'text',
          borderWidth: 1.5,
          borderDash,
          pointRadius: 0,
          pointHitRadius: 0
        }));
  return [...lines, ...aimLines];
}

const logTicks = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000];

function errorOptions() {
  return {
    interaction: {mode: 'index', intersect: false, axis: 'x'},
    scales: {
      x: {
        type: 'linear',
        min: 0,
        max: lastSecond,
        title: {display: true, text: 'time, minutes'},
        ticks: {
          callback: clock,
          stepSize: lastSecond > 300 ? 60 : 15,
          maxRotation: 0,
          autoSkipPadding: 12
        }
      },
      y: {
        type: 'logarithmic',
        min: 1,
        suggestedMax: 1000,
        title: {display: true, text: 'error, mm'},
        afterBuildTicks: (axis) => {
          axis.ticks = logTicks.filter((value) => value >= axis.min && value <= axis.max)
                           .map((value) => ({value}));
        },
        ticks: {callback: (value) => number(value)}
      },
    },
    plugins: {
      legend: {
        labels: {
          usePointStyle: true,
          pointStyle: 'line',
          pointStyleWidth: 34,
          boxWidth: 34,
          generateLabels: (chart) => Chart.defaults.plugins.legend.labels.generateLabels(chart).map(
              (label) => ({...label, lineDash: chart.data.datasets[label.datasetIndex].borderDash}))
        }
      },
      tooltip: {
        filter: (item) => item.datasetIndex < robots.length,
        callbacks: {
          title: (items) => (items.length ? clock(items[0].parsed.x) : ''),
          label: (item) => `${item.dataset.label}: ${number(item.parsed.y)} mm`
        }
      },
    },
  };
}

function showErrors() {
  const shares = lastSecond > 120 ? [1, 10, 30] : [1, 10];
  let length = shares[1];
  const chart = new Chart(byId('errorChart'), {
    type: 'line',
    data: {datasets: errorData(length)},
    options: {...errorOptions(), parsing: false},
    plugins: [matchMarks]
  });
  const paint = () => {
    applyColors();
    for (const line of chart.data.datasets)
      line.borderColor = line.backgroundColor = colorOf(line.colorName);
    chart.options.color = colorOf('soft');
    for (const scale of Object.values(chart.options.scales)) {
      scale.grid = {color: colorOf('line')};
      scale.ticks.color = scale.title.color = colorOf('soft');
    }
    chart.options.plugins.legend.labels.color = colorOf('text');
    chart.update();
  };
  const buttons = shares.map(
      (share) => element('button', {
        text: share === 1 ? `every ${page.sampleSeconds} s` :
                            `median of ${share * page.sampleSeconds} s`,
        'aria-pressed': String(share === length),
        onclick: () => {
          length = share;
          errorData(length).forEach((line, i) => {
            chart.data.datasets[i].data = line.data;
          });
          buttons.forEach(
              (button, i) => button.setAttribute('aria-pressed', String(shares[i] === length)));
          chart.update();
        },
      }));
  byId('smoothButtons').append(...buttons);
  changeOfColors.push(paint);
  changeOfSelection.push(() => chart.draw());
  paint();
}

/** The parts that took longest, and one bar for all others. */
function largestParts(parts, count) {
  if (parts.length <= count) return parts;
  const others = parts.slice(count - 1);
  return [
    ...parts.slice(0, count - 1),
    {part: `${others.length} others`, count: null, totalMs: sum(others.map((part) => part.totalMs))}
  ];
}

function showTimes() {
  const all = [...times.parts].sort((a, b) => b.totalMs - a.totalMs), shown = largestParts(all, 16);
  const total = sum(all.map((part) => part.totalMs)) || 1;
  const meanOf = (part) => (part.count ? number(1000 * part.totalMs / part.count, 1) : '–');
  const share = (part) => number(100 * part.totalMs / total, 1) + ' %';
  byId('timesHint').textContent =
      `${number(times.seconds, 1)} s for ${clock(seconds)} minutes of match on ${times.threads} ` +
      `thread${times.threads === 1 ? '' : 's'}: ${
          number(
              times.realTimeFactor,
              1)} times real time. The parts sum up over all robots and threads.`;
  fillTable(
      byId('timeTable'), 'Computing time of each part',
      [{name: 'part'}, {name: 'calls'}, {name: 'total ms'}, {name: 'mean µs'}, {name: 'share'}],
      all.map(
          (part) =>
              [part.part, number(part.count), number(part.totalMs), meanOf(part), share(part)]));
  byId('timeChartBox').style.height = `${60 + 24 * Math.max(shown.length, 1)}px`;
  const chart = new Chart(byId('timeChart'), {
    type: 'bar',
    data: {
      labels: shown.map((part) => part.part),
      datasets:
          [{data: shown.map((part) => part.totalMs / 1000), borderRadius: 4, maxBarThickness: 18}]
    },
    options: {
      indexAxis: 'y',
      scales: {
        x: {title: {display: true, text: 'computing time, seconds'}, ticks: {}},
        y: {ticks: {autoSkip: false}, grid: {display: false}}
      },
      plugins: {
        legend: {display: false},
        tooltip: {
          callbacks: {
            label: (item) => `${number(item.parsed.x, 2)} s, ${share(shown[item.dataIndex])}`,
            afterLabel: (item) => shown[item.dataIndex].count ?
                `${number(shown[item.dataIndex].count)} calls of ${
                    meanOf(shown[item.dataIndex])} µs` :
                ''
          }
        }
      },
    },
  });
  const paint = () => {
    const {x, y} = chart.options.scales;
    chart.data.datasets[0].backgroundColor = colorOf('bar');
    x.grid = {color: colorOf('line')};
    x.title.color = x.ticks.color = colorOf('soft');
    y.ticks.color = colorOf('text');
    chart.update();
  };
  changeOfColors.push(paint);
  paint();
}

showErrors();
showTimes();
// Paper has another width than the window.
addEventListener(
    'beforeprint', () => Object.values(Chart.instances).forEach((chart) => chart.resize()));
addEventListener(
    'afterprint', () => Object.values(Chart.instances).forEach((chart) => chart.resize()));
