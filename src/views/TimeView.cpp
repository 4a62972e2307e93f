#include <algorithm>

#include "views/ViewText.h"
#include "views/Views.h"

namespace gt {
namespace {

class TimeView : public View {
 public:
  TimeView() : View{"times", "how long each module takes"} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double>) const override {
    const auto robot = subject.robot();
    if (!robot) return robot.error();
    const auto times = (*robot)->times();
    if (!times) return times.error();
    std::vector<Stopwatch> modules;
    for (const auto& [process, known] : **times)
      modules.insert(modules.end(), known.modules.begin(), known.modules.end());
    double longest = 1e-9;
    for (const Stopwatch& watch : modules) longest = std::max(longest, watch.meanMs());
    Sheet sheet{720, TextLines::sheetHeight(modules.size() + 1)};
    TextLines lines{sheet, 16};
    lines.add({{0, (*robot)->name() + ": mean time of each module, times a second"}});
    const double seconds = std::max(secondsOf((*robot)->time()), 1e-3);
    for (const Stopwatch& watch : modules) {
      lines.add({{0, watch.name},
                 {450, decimal(watch.meanMs(), 3) + " ms"},
                 {560, decimal(static_cast<double>(watch.count) / seconds) + " /s"}});
      sheet.box({190, lines.y() - 9}, {std::max(1.0, 260 * watch.meanMs() / longest), 11},
                barColor);
    }
    return sheet;
  }
};

}  // namespace

std::unique_ptr<View> makeTimeView() {
  return std::make_unique<TimeView>();
}

}  // namespace gt
