#pragma once
#include <chrono>
#include <cstdio>
#include <string>

#include "LineEditor.h"
#include "console/Console.h"

namespace gt {

/// Where simgt prints. In a terminal a live line at the bottom shows time, score and how many times
/// faster than real time it goes, above which texts scroll, errors and goals in color. Anywhere
/// else only the texts are printed.
class TerminalScreen : public Screen {
 public:
  TerminalScreen();

  /// What the live line is about.
  void watch(Session& session);
  /// A person types lines here from now on; null: no more. Texts are printed above the line, and
  /// its prompt takes the live line's place.
  void setEditor(LineEditor* editor) { editor_ = editor; }
  /// What a person is asked with: which robots are selected, and the time while it passes.
  std::string prompt(Console& console) const;
  void print(std::string_view line) override;
  void printError(std::string_view line);
  void clear() override;
  void stepped() override;
  /// Takes the live line away.
  void end();

 private:
  using Clock = std::chrono::steady_clock;

  void printLine(std::string_view line, const char* color, std::FILE* file);

  Session* session_ = nullptr;
  LineEditor* editor_ = nullptr;
  bool terminal_;
  std::string live_;
  Clock::time_point shown_;
  Time shownTime_;
};

}  // namespace gt
