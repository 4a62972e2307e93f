#include "LocalizationPage.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/File.h"

namespace gt {
namespace {

constexpr std::array locators{"singlelandmark", "montecarlo", "fusion", "lines",
                              "gt2003",         "fusion2003", "kalman"};

constexpr const char* head =
    R"(<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>Self-locators</title><style>
body { font: 15px/1.45 sans-serif; max-width: 1080px; margin: 2em auto; padding: 0 1em; color: #222; }
h1, h2, h3 { font-weight: 600; } h2, h3 { margin-top: 1.8em; }
.charts { display: grid; grid-template-columns: 1fr 1fr; gap: 1em 2em; }
figure { margin: 0; } figcaption { font-weight: 600; margin-bottom: .3em; }
table { border-collapse: collapse; font-size: 13px; } td, th { padding: .25em .6em; text-align: right; border-bottom: 1px solid #ddd; }
td:first-child, th:first-child { text-align: left; } .missed { color: #b3261e; } .met { color: #1b7f3b; }
svg text { font: 12px sans-serif; fill: #333; }
</style></head><body>
<h1>Self-locators against the truth</h1>
<p>Each bar is the mean over all seeds, the thin line reaches from the lowest seed to the highest. Blue: with beacons on the field;
orange: without. Dashed: the report's figure on a real robot; green: the project's aim. All locators of a run see the same pictures.</p>
)";

/// One chart: a figure of all locators.
struct Chart {
  const char* title;
  const char* figure;
  double report;  ///< 0 if it has none.
  double aim;     ///< 0 if there is none.
};

constexpr std::array charts{
    Chart{"Experiment 1: mean error (mm)", "experiment1.error.mean", 105, 50},
    Chart{"Experiment 1: median error (mm)", "experiment1.error.median", 0, 0},
    Chart{"Experiment 1: 95th percentile of the error (mm)", "experiment1.error.p95", 0, 0},
    Chart{"Experiment 1: longest time off by more than 60 cm (s)", "experiment1.lost.longest", 0,
          0},
    Chart{"Experiment 2: how far off the robot stops (mm)", "experiment2.stop.mean", 94, 40},
    Chart{"Experiment 2: error of the estimate there (mm)", "experiment2.estimate.mean", 84, 30},
    Chart{"From nothing: images until found (median)", "fromNothing.median", 14, 10},
    Chart{"Carried away: images until found (median)", "kidnapped.median", 13, 10},
    Chart{"From nothing: 95th percentile of images", "fromNothing.p95", 40, 0},
    Chart{"Mirror image of the truth, though a goal or beacon was seen (longest, s)",
          "search.mirrored.longest", 0, 2}};

constexpr std::array troubleColumns{std::pair{"", "as in a match"},
                                    std::pair{".missing1", "1 beacon missing"},
                                    std::pair{".missing2", "2"},
                                    std::pair{".missing3", "3"},
                                    std::pair{".missing4", "4"},
                                    std::pair{".missing5", "5"},
                                    std::pair{".missing6", "all 6"},
                                    std::pair{".misplaced10cm", "misplaced by 10 cm"},
                                    std::pair{".wrong10percent", "10 % wrong"},
                                    std::pair{".halfDropped", "half the images"},
                                    std::pair{".robotsInTheWay", "robots in the way"},
                                    std::pair{".leaningOnWalls", "leaning on walls"},
                                    std::pair{".slip30percent", "slip of 30 %"}};

/// A chart of horizontal bars as SVG.
std::string draw(const Chart& chart, const Figures& figures, const std::string& group) {
  constexpr double left = 150, width = 300, row = 17;
  struct Bar {
    std::string label;
    const char* color;
    const Figure* figure;
  };
  std::vector<Bar> bars;
  double most = std::max(chart.report, chart.aim) * 1.05;
  for (const char* locator : locators)
    for (const bool beacons : {true, false}) {
      const std::string name = std::string{locator} + (beacons ? "" : ".nobeacons");
      const Figure* figure = figures.find(group + name + "." + chart.figure);
      if (!figure) continue;
      bars.push_back({beacons ? locator : "", beacons ? "#3b6fb6" : "#e08a2c", figure});
      most = std::max(most, figure->high);
    }
  const double scale = most > 0 ? width / most : 0;
  std::string svg =
      fmt::format("<figure><figcaption>{}</figcaption><svg viewBox=\"0 0 520 {}\" width=\"100%\">",
                  chart.title, row * static_cast<double>(bars.size()) + 4);
  const auto mark = [&](double value, const char* style) {
    if (value > 0)
      svg += fmt::format("<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"0\" y2=\"{1:.0f}\" {2}/>",
                         left + scale * value, row * static_cast<double>(bars.size()), style);
  };
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const Figure& f = *bars[i].figure;
    const double y = row * static_cast<double>(i);
    svg += fmt::format(
        "<text x=\"{}\" y=\"{:.0f}\" text-anchor=\"end\">{}</text><rect x=\"{}\" y=\"{:.0f}\" "
        "width=\"{:.1f}\" height=\"12\" fill=\"{}\"/><line x1=\"{:.1f}\" x2=\"{:.1f}\" "
        "y1=\"{:.0f}\" y2=\"{:.0f}\" stroke=\"#222\"/><text x=\"{:.1f}\" "
        "y=\"{:.0f}\">{:.1f}</text>",
        left - 8, y + 11, bars[i].label, left, y + 1, scale * f.value, bars[i].color,
        left + scale * f.low, left + scale * f.high, y + 7, y + 7,
        left + scale * std::max(f.value, f.high) + 6, y + 11, f.value);
  }
  mark(chart.report, "stroke=\"#222\" stroke-dasharray=\"4 3\"");
  mark(chart.aim, "stroke=\"#1b7f3b\" stroke-width=\"2\"");
  return svg + "</svg></figure>\n";
}

/// The table of a figure by locator and trouble, the darker the worse.
std::string robustness(const std::string& title, const std::string& group, const char* where,
                       const char* figure, double worst, const char* format,
                       const Figures& figures) {
  std::string html = fmt::format("<h3>{}</h3><table><tr><th></th>", title);
  for (const auto& [suffix, label] : troubleColumns) html += fmt::format("<th>{}</th>", label);
  html += "</tr>\n";
  for (const char* locator : locators) {
    html += fmt::format("<tr><td>{}</td>", locator);
    for (const auto& [suffix, label] : troubleColumns) {
      const Figure* f = figures.find(group + std::string{locator} + where + suffix + "." + figure);
      const double shade = f ? std::clamp(f->value / worst, 0., 1.) : 0;
      html += fmt::format("<td style=\"background:rgba(220,60,40,{:.2f})\">{}</td>", 0.6 * shade,
                          f ? fmt::format(fmt::runtime(format), f->value) : "");
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

std::string table(const Figures& figures) {
  std::string html =
      "<h2>All figures</h2><table><tr><th>figure</th><th>mean</th><th>median</th><th>95 %</th>"
      "<th>low</th><th>high</th><th>unit</th><th>seeds</th><th>aim</th></tr>\n";
  for (const Figure& f : figures.all()) {
    if (!f.name.starts_with("localization.")) continue;
    html += fmt::format(
        "<tr><td>{}</td><td>{:.1f}</td><td>{:.1f}</td><td>{:.1f}</td><td>{:.1f}</td>"
        "<td>{:.1f}</td><td>{}</td><td>{}</td>",
        f.name, f.value, f.median, f.p95, f.low, f.high, f.unit, f.n);
    if (f.aim.kind == Aim::Kind::none)
      html += "<td></td></tr>\n";
    else
      html +=
          fmt::format("<td class=\"{}\">{} {:g}</td></tr>\n", f.aim.met(f.value) ? "met" : "missed",
                      f.aim.kind == Aim::Kind::atMost ? "&le;" : "&ge;", f.aim.value);
  }
  return html + "</table>\n";
}

}  // namespace

Result<void> writeLocalizationPage(const std::string& path, const Figures& figures,
                                   const std::string& note) {
  const auto both = [&](const std::string& title, const std::string& group, const char* where) {
    return robustness(title + ": mean error (mm)", group, where, "error.mean", 400, "{:.0f}",
                      figures) +
           robustness(title + ": longest time off by more than 60 cm (s)", group, where,
                      "lost.longest", 20, "{:.1f}", figures);
  };
  const std::string all = "localization.";
  std::string html = head;
  if (!note.empty()) html += fmt::format("<p class=\"missed\">{}</p>\n", note);
  for (const auto& [profile, group] : {std::pair{"padova", all}, {"benign", all + "benign."}}) {
    html += fmt::format("<h2>In the profile {}</h2>\n<div class=\"charts\">\n", profile);
    for (const Chart& chart : charts) html += draw(chart, figures, group);
    html += "</div>\n" + both("Robustness on simulated images", group, ".pictures");
  }
  html += "<h2>Without simulated images</h2>\n" + both("Robustness on the test bench", all, "");
  html += table(figures) + "</body></html>\n";
  return writeFile(path, html);
}

}  // namespace gt
