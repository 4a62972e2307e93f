#include "crash/ElfFile.h"

#include <elf.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "crash/BuildId.h"

namespace gt {

/// Takes what is wanted from bytes that are not trusted.
class ElfParser {
 public:
  ElfParser(std::ifstream& stream, std::uint64_t size) : stream_{stream}, size_{size} {}

  bool parse(ElfFile& file) {
    Elf64_Ehdr header;
    if (!get(0, header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
        header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_ident[EI_DATA] != ELFDATA2LSB)
      return false;
    std::vector<Elf64_Shdr> sections;
    for (std::uint64_t i = 0; i < header.e_shnum; ++i) {
      Elf64_Shdr section;
      if (!get(header.e_shoff + i * sizeof section, section)) return false;
      sections.push_back(section);
    }
    const std::string names =
        header.e_shstrndx < sections.size() ? bytes(sections[header.e_shstrndx]) : "";
    for (const Elf64_Shdr& section : sections) {
      if (section.sh_type == SHT_NOTE)
        if (std::string id = buildIdOf(bytes(section)); !id.empty()) file.buildId_ = std::move(id);
      if ((section.sh_type == SHT_SYMTAB || section.sh_type == SHT_DYNSYM) &&
          section.sh_link < sections.size())
        readSymbols(bytes(section), bytes(sections[section.sh_link]), file);
      if (section.sh_type != SHT_NOBITS && textAt(names, section.sh_name) == ".debug_line")
        file.hasLines_ = true;
    }
    std::sort(file.functions_.begin(), file.functions_.end(),
              [](const ElfFunction& a, const ElfFunction& b) { return a.begin < b.begin; });
    return true;
  }

 private:
  static constexpr std::uint64_t largestSection = 1u << 28;

  std::string bytes(std::uint64_t offset, std::uint64_t size) {
    if (offset > size_ || size > size_ - offset || size > largestSection) return {};
    std::string result(static_cast<std::size_t>(size), '\0');
    stream_.clear();
    stream_.seekg(static_cast<std::streamoff>(offset));
    stream_.read(result.data(), static_cast<std::streamsize>(size));
    return stream_.gcount() == static_cast<std::streamsize>(size) ? result : std::string{};
  }
  std::string bytes(const Elf64_Shdr& section) {
    return section.sh_type == SHT_NOBITS ? "" : bytes(section.sh_offset, section.sh_size);
  }
  template <typename T>
  bool get(std::uint64_t offset, T& value) {
    const std::string content = bytes(offset, sizeof value);
    if (content.size() != sizeof value) return false;
    std::memcpy(&value, content.data(), sizeof value);
    return true;
  }
  static std::string_view textAt(std::string_view table, std::size_t at) {
    if (at >= table.size()) return {};
    const auto end = table.find('\0', at);
    return table.substr(at, end == table.npos ? end : end - at);
  }

  static void readSymbols(std::string_view symbols, std::string_view names, ElfFile& file) {
    for (; symbols.size() >= sizeof(Elf64_Sym); symbols.remove_prefix(sizeof(Elf64_Sym))) {
      Elf64_Sym symbol;
      std::memcpy(&symbol, symbols.data(), sizeof symbol);
      if (ELF64_ST_TYPE(symbol.st_info) != STT_FUNC || symbol.st_value == 0) continue;
      file.functions_.push_back(
          {std::string{textAt(names, symbol.st_name)}, symbol.st_value, symbol.st_size});
    }
  }

  std::ifstream& stream_;
  std::uint64_t size_;
};

Result<ElfFile> ElfFile::read(const std::string& path) {
  std::error_code failure;
  if (!std::filesystem::is_regular_file(path, failure))
    return Error{.file = path, .what = "there is no such file"};
  std::ifstream stream{path, std::ios::binary};
  if (!stream) return Error{.file = path, .what = "cannot be read"};
  ElfFile file;
  file.path_ = path;
  if (!ElfParser{stream, std::filesystem::file_size(path, failure)}.parse(file))
    return Error{.file = path, .what = "is no program (64-bit ELF)"};
  return file;
}

std::optional<ElfFunction> ElfFile::functionAt(std::uint64_t address) const {
  auto after = std::upper_bound(
      functions_.begin(), functions_.end(), address,
      [](std::uint64_t at, const ElfFunction& function) { return at < function.begin; });
  if (after == functions_.begin()) return std::nullopt;
  const ElfFunction& function = *--after;
  if (address - function.begin >= std::max<std::uint64_t>(function.size, 1)) return std::nullopt;
  return function;
}

}  // namespace gt
