#include "crash/Symbolizer.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "base/Program.h"
#include "crash/BuildId.h"

namespace gt {
namespace {

/// Entries of a folder beyond this are not looked at.
constexpr int mostFiles = 20'000;

/// FILE:LINE, maybe with " (discriminator 3)" behind it.
void readPlace(const std::string& text, SourcePlace& place) {
  const auto colon = text.rfind(':', text.find(" ("));
  if (colon == text.npos || text.starts_with("??")) return;
  int line = 0;
  std::from_chars(text.data() + colon + 1, text.data() + text.size(), line);
  if (line <= 0) return;
  place.file = text.substr(0, colon);
  place.line = line;
}

/// One line of objdump: "  401136:\tmov %rax,%rbx".
std::optional<Instruction> readInstruction(const std::string& line) {
  const auto begin = line.find_first_not_of(' ');
  const auto colon = line.find(":\t");
  if (begin == line.npos || colon == line.npos || begin == 0) return std::nullopt;
  Instruction result;
  const auto [end, failure] =
      std::from_chars(line.data() + begin, line.data() + colon, result.address, 16);
  if (failure != std::errc{} || end != line.data() + colon) return std::nullopt;
  result.text = line.substr(colon + 2);
  return result;
}

}  // namespace

Symbolizer::Symbolizer(const CrashReport& report, std::vector<std::string> symbolFolders)
    : report_{report}, folders_{std::move(symbolFolders)} {
  folders_.emplace_back("/usr/lib/debug");
}

std::optional<ElfFile> Symbolizer::findSymbols(const std::string& buildId) const {
  if (buildId.size() < 4) return std::nullopt;
  const auto matches = [&](const std::string& path) -> std::optional<ElfFile> {
    auto file = ElfFile::read(path);
    if (!file || file->buildId() != buildId || !file->hasFunctions()) return std::nullopt;
    return std::move(*file);
  };
  for (const std::string& folder : folders_)
    if (auto file = matches(folder + "/.build-id/" + buildId.substr(0, 2) + "/" +
                            buildId.substr(2) + ".debug"))
      return file;
  // The last folder is Debian's, which is large and in order.
  for (std::size_t i = 0; i + 1 < folders_.size(); ++i) {
    std::error_code failure;
    int count = 0;
    for (std::filesystem::recursive_directory_iterator at{folders_[i], failure}, end;
         !failure && at != end && ++count < mostFiles; at.increment(failure))
      if (auto file = matches(at->path().string())) return file;
  }
  return std::nullopt;
}

Symbolizer::Files& Symbolizer::filesOf(const CrashModule& module) {
  const auto known = files_.find(&module);
  if (known != files_.end()) return known->second;
  Files& files = files_[&module];
  auto code = ElfFile::read(module.path);
  if (!code)
    missing_.push_back(code.error());
  else if (code->buildId() != module.buildId)
    missing_.push_back(
        {.file = module.path, .what = "is not the one that crashed: its build id differs"});
  else
    files.code = std::move(*code);
  files.symbols = files.code && files.code->hasLines() ? files.code : findSymbols(module.buildId);
  if (!files.symbols) files.symbols = files.code;
  // Whole programs kept apart tell the code, too.
  if (!files.code && files.symbols) files.code = files.symbols;
  return files;
}

std::vector<SourcePlace> Symbolizer::placesIn(const Files& files, std::uint64_t address) const {
  std::vector<SourcePlace> places;
  if (files.symbols) {
    const auto output = runProgram({"addr2line", "--functions", "--demangle", "--inlines",
                                    "--exe=" + files.symbols->path(), hexText(address)});
    std::istringstream lines{output ? output->output : ""};
    for (std::string function, place;
         std::getline(lines, function) && std::getline(lines, place);) {
      SourcePlace& p = places.emplace_back();
      p.function = function == "??" ? "?" : function;
      readPlace(place, p);
    }
  }
  if (places.empty()) places.push_back({"?", "", 0});
  return places;
}

std::vector<SourcePlace> Symbolizer::places(std::uint64_t address) {
  const CrashModule* module = report_.moduleAt(address);
  if (!module) return {{"?", "", 0}};
  return placesIn(filesOf(*module), address - module->base);
}

Result<std::vector<Instruction>> Symbolizer::assembler(std::uint64_t address, std::size_t count) {
  const CrashModule* module = report_.moduleAt(address);
  if (!module) return Error{.field = hexText(address), .what = "lies in no program or library"};
  const Files& files = filesOf(*module);
  if (!files.code) return Error{.file = module->path, .what = "its code is not there"};
  const std::uint64_t at = address - module->base;
  // From the function's begin on, as instructions can only be decoded from there.
  std::uint64_t begin = at, end = at + 16 * count;
  if (files.symbols)
    if (const auto function = files.symbols->functionAt(at)) {
      begin = function->begin;
      end = std::max(at + 1, function->begin + function->size);
    }
  const auto output = runProgram({"objdump", "--disassemble", "--demangle", "--no-show-raw-insn",
                                  "--start-address=" + hexText(begin),
                                  "--stop-address=" + hexText(end), "--", files.code->path()});
  if (!output) return output.error();
  std::vector<Instruction> all;
  std::istringstream lines{output->output};
  for (std::string line; std::getline(lines, line);)
    if (auto instruction = readInstruction(line)) all.push_back(std::move(*instruction));
  const auto crash =
      std::find_if(all.begin(), all.end(), [&](const Instruction& i) { return i.address >= at; });
  const auto index = static_cast<std::size_t>(crash - all.begin());
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), index + count + 1)),
            all.end());
  all.erase(all.begin(),
            all.begin() + static_cast<std::ptrdiff_t>(index > count ? index - count : 0));
  for (Instruction& instruction : all) {
    instruction.place = placesIn(files, instruction.address).front();
    instruction.address += module->base;
  }
  return all;
}

}  // namespace gt
