#include "crash/Symbolizer.h"

#include <cxxabi.h>
#include <dwarf.h>
#include <elfutils/libdwelf.h>
#include <elfutils/libdwfl.h>
#include <fcntl.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <optional>
#include <sstream>

#include "base/FileDescriptor.h"
#include "base/Number.h"
#include "base/Program.h"
#include "crash/BuildId.h"

namespace gt {
namespace {

/// Entries of a folder beyond this are not looked at.
constexpr int mostFiles = 20'000;

/// The build id of a file in hex; empty if it has none. Returns an error if it is not an ELF file.
Result<std::string> buildIdOfFile(const std::string& path) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure))
    return Error{.file = path, .what = "there is no such file"};
  const FileDescriptor file{open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (!file) return Error{.file = path, .what = "cannot be read"};
  elf_version(EV_CURRENT);
  const std::unique_ptr<Elf, int (*)(Elf*)> elf{elf_begin(file.number(), ELF_C_READ, nullptr),
                                                elf_end};
  if (elf_kind(elf.get()) != ELF_K_ELF) return Error{.file = path, .what = "is no program (ELF)"};
  const void* id = nullptr;
  const auto size = dwelf_elf_gnu_build_id(elf.get(), &id);
  return size > 0 ? hexDigits({static_cast<const char*>(id), static_cast<std::size_t>(size)}) : "";
}

/// A function's name as in the source: without what tells the compiler's copies of it apart, such
/// as .cold and .localalias.
std::string demangled(const char* name) {
  if (!name) return "?";
  const std::string own{name, std::strcspn(name, ".")};
  const std::unique_ptr<char, void (*)(void*)> text{
      abi::__cxa_demangle(own.c_str(), nullptr, nullptr, nullptr), std::free};
  return text ? text.get() : name;
}

/// The name of a function in the debug information, with its parameters where it has them.
std::string functionName(Dwarf_Die& function) {
  Dwarf_Attribute attribute;
  const char* linked =
      dwarf_formstring(dwarf_attr_integrate(&function, DW_AT_linkage_name, &attribute));
  return demangled(linked ? linked : dwarf_diename(&function));
}

/// The number that an attribute has; 0 if there is none.
std::size_t numberIn(Dwarf_Die& die, unsigned int name) {
  Dwarf_Attribute attribute;
  Dwarf_Word number = 0;
  dwarf_formudata(dwarf_attr(&die, name, &attribute), &number);
  return number;
}

/// Completes the place of an address, of which the function's symbol is known, by what the debug
/// information of its compilation unit has.
std::vector<SourcePlace> placesIn(Dwarf_Die& unit, std::uint64_t address, SourcePlace place) {
  if (Dwarf_Line* line = dwarf_getsrc_die(&unit, address)) {
    if (const char* file = dwarf_linesrc(line, nullptr, nullptr)) place.file = file;
    dwarf_lineno(line, &place.line);
  }
  std::vector<SourcePlace> places{place};
  Dwarf_Files* files = nullptr;
  dwarf_getsrcfiles(&unit, &files, nullptr);
  Dwarf_Die *innermost = nullptr, *scopes = nullptr;
  const int count =
      dwarf_getscopes(&unit, address, &innermost) > 0 ? dwarf_getscopes_die(innermost, &scopes) : 0;
  for (int i = 0; i < count; ++i) {
    if (dwarf_tag(&scopes[i]) != DW_TAG_inlined_subroutine) continue;
    places.back().function = functionName(scopes[i]);
    const char* file = dwarf_filesrc(files, numberIn(scopes[i], DW_AT_call_file), nullptr, nullptr);
    places.push_back(
        {place.function, file ? file : "", static_cast<int>(numberIn(scopes[i], DW_AT_call_line))});
  }
  std::free(innermost);
  std::free(scopes);
  return places;
}

/// The place of an address of a file, after it those that it was inlined into. Never empty.
std::vector<SourcePlace> placesIn(Dwfl_Module* symbols, std::uint64_t address) {
  if (!symbols) return {{}};
  const SourcePlace place{demangled(dwfl_module_addrname(symbols, address)), "", 0};
  // Not by .debug_aranges, which clang does not write.
  Dwarf_Addr bias = 0;
  for (Dwarf_Die* unit = nullptr; (unit = dwfl_module_nextcu(symbols, unit, &bias));)
    if (dwarf_haspc(unit, address - bias) > 0) return placesIn(*unit, address - bias, place);
  return {place};
}

/// One line of objdump: "  401136:\tmov %rax,%rbx".
std::optional<Instruction> readInstruction(const std::string& line) {
  const auto begin = line.find_first_not_of(' ');
  const auto colon = line.find(":\t");
  if (begin == line.npos || colon == line.npos || begin == 0) return std::nullopt;
  const auto address =
      numberFrom<std::uint64_t>(std::string_view{line}.substr(begin, colon - begin), 16);
  if (!address) return std::nullopt;
  return Instruction{*address, line.substr(colon + 2), {}};
}

}  // namespace

Symbolizer::Symbolizer(const CrashReport& report, const std::vector<std::string>& symbolFolders)
    : report_{report} {
  for (const std::string& folder : symbolFolders) {
    std::error_code failure;
    int count = 0;
    for (std::filesystem::recursive_directory_iterator at{folder, failure}, end;
         !failure && at != end && ++count < mostFiles; at.increment(failure))
      if (const auto id = buildIdOfFile(at->path().string()); id && !id->empty())
        symbols_.emplace(*id, at->path().string());
  }
}

bool Symbolizer::Files::open(const std::string& path) {
  // Finds Debian's symbols of a program that has none itself.
  static const Dwfl_Callbacks callbacks{nullptr, dwfl_standard_find_debuginfo, nullptr, nullptr};
  session = {dwfl_begin(&callbacks), dwfl_end};
  symbols = dwfl_report_elf(session.get(), path.c_str(), path.c_str(), -1, 0, true);
  dwfl_report_end(session.get(), nullptr, nullptr);
  Dwarf_Addr bias = 0;
  return symbols && dwfl_module_getdwarf(symbols, &bias);
}

Symbolizer::Files& Symbolizer::filesOf(const CrashModule& module) {
  const auto [known, isNew] = files_.try_emplace(&module);
  Files& files = known->second;
  if (!isNew) return files;
  if (const auto id = buildIdOfFile(module.path); !id)
    missing_.push_back(id.error());
  else if (*id != module.buildId)
    missing_.push_back(
        {.file = module.path, .what = "is not the one that crashed: its build id differs"});
  else if (files.open(files.code = module.path))
    return files;
  const auto [begin, end] = symbols_.equal_range(module.buildId);
  for (auto at = begin; at != end; ++at) {
    // Whole programs kept apart have the code, too.
    if (files.code.empty()) files.code = at->second;
    if (files.open(at->second)) break;
  }
  return files;
}

std::vector<SourcePlace> Symbolizer::places(std::uint64_t address) {
  const CrashModule* module = report_.moduleAt(address);
  if (!module) return {{}};
  return placesIn(filesOf(*module).symbols, address - module->base);
}

Result<std::vector<Instruction>> Symbolizer::assembler(std::uint64_t address, std::size_t count) {
  const CrashModule* module = report_.moduleAt(address);
  if (!module) return Error{.field = hexText(address), .what = "lies in no program or library"};
  const Files& files = filesOf(*module);
  if (files.code.empty()) return Error{.file = module->path, .what = "its code is not there"};
  const std::uint64_t at = address - module->base;
  // From the function's begin on, as instructions can only be decoded from there.
  std::uint64_t begin = at, end = at + 16 * count;
  GElf_Off offset = 0;
  GElf_Sym function;
  if (files.symbols &&
      dwfl_module_addrinfo(files.symbols, at, &offset, &function, nullptr, nullptr, nullptr)) {
    begin = at - offset;
    end = std::max(at + 1, begin + function.st_size);
  }
  const auto output = runProgram({"objdump", "--disassemble", "--demangle", "--no-show-raw-insn",
                                  "--start-address=" + hexText(begin),
                                  "--stop-address=" + hexText(end), "--", files.code});
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
    instruction.place = placesIn(files.symbols, instruction.address).front();
    instruction.address += module->base;
  }
  return all;
}

}  // namespace gt
