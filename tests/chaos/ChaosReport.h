#pragma once
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/File.h"
#include "streams/Json.h"

namespace gt {

/// What faults of one kind did to a robot.
struct ChaosOutcome {
  std::string kind;
  std::vector<double> again{};  ///< s from the end of each fault until all played again.
  double commands = 0;          ///< s without commands to the joints, of all faults.
  std::int64_t images = 0;      ///< Images that were not answered, of all faults.
  std::vector<double> gaps{};   ///< s that the logs lack before and after each fault.
  std::size_t logs = 0, messages = 0;
};

/// The table of all kinds; its last act is to print it, and to write it where GT_CHAOS says.
class ChaosReport {
 public:
  ChaosReport() = default;
  ~ChaosReport() {
    if (outcomes_.empty()) return;
    Json all = Json::array();
    fmt::print("\n{:<42}{:>7}{:>9}{:>8}{:>10}{:>8}{:>9}{:>6}{:>10}\n", "", "faults", "again",
               "most", "commands", "images", "log gap", "logs", "messages");
    fmt::print("{:<42}{:>7}{:>9}{:>8}{:>10}{:>8}{:>9}\n", "", "", "median s", "s", "lost s", "lost",
               "most s");
    for (ChaosOutcome& o : outcomes_) {
      std::ranges::sort(o.again);
      const auto n = static_cast<double>(std::max<std::size_t>(o.again.size(), 1));
      const double median = o.again.empty() ? 0 : o.again[o.again.size() / 2];
      const double most = o.again.empty() ? 0 : o.again.back();
      const double gap = o.gaps.empty() ? 0 : *std::ranges::max_element(o.gaps);
      const double images = static_cast<double>(o.images) / n;
      fmt::print("{:<42}{:>7}{:>9.2f}{:>8.2f}{:>10.2f}{:>8.1f}{:>9.2f}{:>6}{:>10}\n", o.kind,
                 o.again.size(), median, most, o.commands / n, images, gap, o.logs, o.messages);
      all.push_back(Json{{"kind", o.kind},
                         {"faults", o.again.size()},
                         {"again", o.again},
                         {"commandsLost", o.commands / n},
                         {"imagesLost", images},
                         {"logGap", gap},
                         {"logs", o.logs},
                         {"messages", o.messages}});
    }
    const char* file = std::getenv("GT_CHAOS");
    if (!file) return;
    if (const auto done = writeFile(file, all.dump(1) + "\n"); !done)
      fmt::print(stderr, "{}\n", done.error().text());
  }
  ChaosReport(const ChaosReport&) = delete;
  ChaosReport& operator=(const ChaosReport&) = delete;

  ChaosOutcome& add(const std::string& kind) {
    return outcomes_.emplace_back(ChaosOutcome{.kind = kind});
  }

 private:
  std::vector<ChaosOutcome> outcomes_;
};

}  // namespace gt
