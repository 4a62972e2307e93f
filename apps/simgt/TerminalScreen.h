#pragma once
#include <chrono>
#include <string>

#include "console/Console.h"

namespace gt {

/// Where simgt prints. In a terminal a live line at the bottom shows time, score and how many times
/// faster than real time it goes, above which texts scroll, errors and goals in colour. Anywhere
/// else only the texts are printed.
class TerminalScreen : public Screen {
 public:
  TerminalScreen();

  /// What the live line is about.
  void watch(Session& session);
  void print(std::string_view line) override;
  void printError(std::string_view line);
  void clear() override;
  void stepped() override;
  /// Takes the live line away.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  Session* session_ = nullptr;
  bool terminal_;
  std::string live_;
  Clock::time_point shown_;
  Time shownTime_;
};

}  // namespace gt
