#include <fmt/chrono.h>
#include <fmt/core.h>

#include <fstream>

#include "base/File.h"
#include "commandline/CommandLine.h"
#include "crash/Symbolizer.h"

namespace {

using namespace gt;

std::string describe(const SourcePlace& place) {
  return place.file.empty() ? place.function
                            : fmt::format("{} at {}:{}", place.function, place.file, place.line);
}

void printHead(const CrashReport& report) {
  fmt::print("{} (process {}, thread {}) died of signal {} {}", report.program, report.process,
             report.thread, report.signalNumber, report.signal);
  if (report.sender != 0 && report.sender != report.process)
    fmt::print(", sent by process {}", report.sender);
  else if (report.sender == 0 && (report.signal == "SIGSEGV" || report.signal == "SIGBUS"))
    fmt::print(", accessing {:#x}", report.address);
  fmt::print("\n");
  if (report.time > 0 && report.time < 253'402'300'799)
    fmt::print("on {:%Y-%m-%d %H:%M:%S} UTC\n", fmt::gmtime(static_cast<std::time_t>(report.time)));
  if (!report.running.empty()) fmt::print("while it ran {}\n", report.running);
  if (!report.complete)
    fmt::print("The report ends early: the process could not write all of it.\n");
}

void printRegisters(const CrashReport& report) {
  fmt::print("\nRegisters\n");
  for (std::size_t i = 0; i < report.registers.size(); ++i)
    fmt::print("{}{:>7} {:016x}", i % 3 == 0 && i > 0 ? "\n" : "", report.registers[i].first,
               report.registers[i].second);
  fmt::print("\n");
}

/// A line of a source file; empty if that is not there.
std::string sourceLine(const SourcePlace& place) {
  std::ifstream file{place.file};
  std::string text;
  for (int line = 0; line < place.line; ++line)
    if (!std::getline(file, text)) return "";
  const auto begin = text.find_first_not_of(" \t");
  return begin == text.npos ? "" : text.substr(begin);
}

void printAssembler(const char* title, Symbolizer& symbolizer, std::uint64_t address) {
  const auto instructions = symbolizer.assembler(address, 8);
  if (!instructions || instructions->empty()) return;
  fmt::print("\n{}\n", title);
  std::string last;
  for (const Instruction& instruction : *instructions) {
    const std::string place = describe(instruction.place);
    if (place != last && !instruction.place.file.empty())
      fmt::print("   {}: {}\n", place, sourceLine(instruction.place));
    last = place;
    fmt::print("{} {:12x}  {}\n", instruction.address == address ? "=>" : "  ", instruction.address,
               instruction.text);
  }
}

void printCallStack(const CrashReport& report, Symbolizer& symbolizer) {
  fmt::print("\nCall stack{}\n", report.frames.empty() ? ", guessed from the stack's content" : "");
  const auto stack = report.callStack();
  for (std::size_t i = 0; i < stack.size(); ++i) {
    // A return address stands behind the call.
    const auto places = symbolizer.places(stack[i] - (i > 0 ? 1 : 0));
    const CrashModule* module = report.moduleAt(stack[i]);
    fmt::print("{:4} {:16x}  {}  [{}]\n", i, stack[i], describe(places.front()),
               module ? module->path : "nowhere");
    for (std::size_t k = 1; k < places.size(); ++k)
      fmt::print("{:24}inlined into {}\n", "", describe(places[k]));
  }
}

Result<void> run(const std::string& file, const std::vector<std::string>& folders) {
  const auto text = readFile(file);
  if (!text) return text.error();
  const auto report = parseCrashReport(*text, file);
  if (!report) return report.error();
  Symbolizer symbolizer{*report, folders};
  printHead(*report);
  printRegisters(*report);
  printCallStack(*report, symbolizer);
  const auto stack = report->callStack();
  printAssembler("Where it crashed", symbolizer, stack.front());
  if (stack.size() > 1) printAssembler("In the caller", symbolizer, stack[1]);
  if (!report->notes.empty()) fmt::print("\nLast notes\n");
  for (const std::string& note : report->notes) fmt::print("  {}\n", note);
  fmt::print("\nPrograms and libraries\n");
  for (const CrashModule& module : report->modules)
    fmt::print("  {:x}..{:x}  {}  {}\n", module.begin, module.end,
               module.buildId.empty() ? "-" : module.buildId, module.path);
  for (const Error& missing : symbolizer.missing())
    fmt::print(stderr, "crashlog: {}\n", missing.text());
  return {};
}

}  // namespace

/// crashlog: makes a crash report readable (report 5.5).
int main(int argc, char** argv) {
  CommandLine line{argc, argv,
                   "Turns a crash report into source lines, the call stack and assembler"};
  std::string file;
  std::vector<std::string> folders;
  line.app().add_option("report", file, "crash-PROGRAM-PID.txt")->required();
  line.app()
      .add_option("--symbols", folders,
                  "Folder with the symbols of stripped programs, or these with symbols")
      ->check(CLI::ExistingDirectory);
  return line.run([&] { return run(file, folders); });
}
