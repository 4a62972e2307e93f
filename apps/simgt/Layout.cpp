#include "Layout.h"

#include <fmt/core.h>

#include <filesystem>

#include "robot/Robot.h"
#include "robot/replay/LogPlatform.h"
#include "views/graphs/Graphviz.h"
#include "views/graphs/LayoutDrawing.h"

namespace gt {

Result<void> showLayout(const LayoutOptions& options) {
  const auto layout = loadLayout(options.layout);
  if (!layout) return layout.error();
  auto plan = robotPlan(*layout, platformRepresentations());
  // A robot on a log gets from it what others work out for themselves.
  if (!plan)
    if (auto onLog = robotPlan(*layout, LogPlatform::representations()); onLog) plan = onLog;
  if (!plan) return plan.error();
  fmt::print("{}", describePlan(*plan));
  if (options.svg.empty()) return {};
  std::error_code ignored;  // then drawing reports what is wrong
  std::filesystem::create_directories(std::filesystem::path{options.svg}.parent_path(), ignored);
  if (const auto done = writeSvg(drawPlan(*plan), options.svg); !done) return done;
  fmt::print("Drawing: {}\n", options.svg);
  return {};
}

}  // namespace gt
