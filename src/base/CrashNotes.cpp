#include "base/CrashNotes.h"

namespace gt {

CrashNotes& CrashNotes::ofProcess() {
  static constinit CrashNotes notes;
  return notes;
}

void CrashNotes::add(std::string_view line) {
  auto& note = notes_[added_.fetch_add(1) % count];
  std::size_t n = 0;
  const auto put = [&](char c) {
    if (n < length) note[n++].store(c == '\n' || c == 0 ? ' ' : c, std::memory_order_relaxed);
  };
  const auto putAll = [&](std::string_view text) {
    for (const char c : text) put(c);
  };
  bool any = false;
  CrashContext::forEachPart([&](std::string_view part) {
    putAll(part);
    any = true;
  });
  if (any) putAll(": ");
  putAll(line);
  if (n < length) note[n].store(0, std::memory_order_relaxed);
}

void noteForCrashReport(std::string_view line) {
  CrashNotes::ofProcess().add(line);
}

}  // namespace gt
