#include "crash/CrashReport.h"

#include <algorithm>
#include <cstring>
#include <optional>

#include "base/Lines.h"
#include "base/Number.h"

namespace gt {
namespace {

constexpr std::string_view heading = "gt2003 crash report 1";
/// Far beyond what is written: a guard against garbage.
constexpr std::size_t mostLines = 20'000;

std::string_view takePart(std::string_view& text) {
  const auto end = std::min(text.find(' '), text.size());
  const auto word = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

std::optional<std::uint64_t> hex(std::string_view text) {
  if (!text.starts_with("0x")) return std::nullopt;
  return numberFrom<std::uint64_t>(text.substr(2), 16);
}

template <typename N>
bool set(N& to, const auto& number) {
  if (number) to = static_cast<N>(*number);
  return static_cast<bool>(number);
}

bool addModule(std::string_view text, CrashReport& report) {
  CrashModule module;
  const bool good = set(module.base, hex(takePart(text))) &&
                    set(module.begin, hex(takePart(text))) && set(module.end, hex(takePart(text)));
  module.buildId = takePart(text);
  if (module.buildId == "-") module.buildId.clear();
  const bool isHex = module.buildId.find_first_not_of("0123456789abcdef") == std::string::npos;
  module.path = text;
  report.modules.push_back(std::move(module));
  return good && isHex && !text.empty();
}

bool addStack(std::string_view text, CrashReport& report) {
  const auto begin = hex(takePart(text));
  if (!begin || text.size() % 2 != 0) return false;
  if (report.stack.empty()) report.stackBegin = *begin;
  if (*begin != report.stackBegin + report.stack.size()) return false;
  for (std::size_t i = 0; i < text.size(); i += 2) {
    const auto byte = numberFrom<unsigned char>(text.substr(i, 2), 16);
    if (!byte) return false;
    report.stack.push_back(*byte);
  }
  return true;
}

bool addRegister(std::string_view text, CrashReport& report) {
  const auto name = takePart(text);
  const auto value = hex(text);
  if (name.empty() || !value) return false;
  report.registers.emplace_back(name, *value);
  return true;
}

/// Returns false if the line does not match.
bool readLine(std::string_view key, std::string_view text, CrashReport& report) {
  if (key == "program") return report.program = text, true;
  if (key == "signal") {
    const bool good = set(report.signalNumber, numberFrom<int>(takePart(text)));
    return report.signal = text, good;
  }
  if (key == "code") return set(report.code, numberFrom<int>(text));
  if (key == "sender") return set(report.sender, numberFrom<std::int64_t>(text));
  if (key == "address") return set(report.address, hex(text));
  if (key == "time") return set(report.time, numberFrom<std::int64_t>(text));
  if (key == "process") return set(report.process, numberFrom<std::int64_t>(text));
  if (key == "thread") return set(report.thread, numberFrom<std::int64_t>(text));
  if (key == "register") return addRegister(text, report);
  if (key == "module") return addModule(text, report);
  if (key == "running") return report.running = text, true;
  if (key == "note") return report.notes.emplace_back(text), true;
  if (key == "stack") return addStack(text, report);
  if (key == "frame") return set(report.frames.emplace_back(), hex(text));
  if (key == "end") return report.complete = true;
  return false;
}

}  // namespace

const CrashModule* CrashReport::moduleAt(std::uint64_t at) const {
  for (const CrashModule& module : modules)
    if (at >= module.begin && at < module.end) return &module;
  return nullptr;
}

std::vector<std::uint64_t> CrashReport::callStack() const {
  if (!frames.empty()) return frames;
  std::vector<std::uint64_t> found{programCounter()};
  for (std::size_t i = 0; i + 8 <= stack.size() && found.size() < 100; i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, stack.data() + i, sizeof word);
    if (moduleAt(word)) found.push_back(word);
  }
  return found;
}

Result<CrashReport> parseCrashReport(std::string_view text, const std::string& file) {
  CrashReport report;
  LineReader lines{text};
  while (const auto whole = lines.next()) {
    std::string_view row = *whole;
    const bool cutOff = row.data() + row.size() == text.data() + text.size();
    const auto wrong = [&](std::string what) {
      return Error{.file = file, .line = lines.number(), .what = std::move(what)};
    };
    if (lines.number() == 1) {
      if (row != heading) return wrong("is no crash report");
      continue;
    }
    if (static_cast<std::size_t>(lines.number()) > mostLines)
      return wrong("the report is too long");
    const auto key = takePart(row);
    if (!readLine(key, row, report) && !cutOff)
      return wrong("expected a line of a crash report, not " + std::string{key.substr(0, 40)});
  }
  if (report.signal.empty() && report.modules.empty())
    return Error{.file = file, .what = "is no crash report, or ends before it tells anything"};
  return report;
}

}  // namespace gt
