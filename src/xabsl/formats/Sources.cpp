#include "xabsl/formats/Sources.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

#include "xabsl/formats/XmlParser.h"
#include "xabsl/formats/XmlReader.h"
#include "xabsl/formats/XmlSchema.h"
#include "xabsl/formats/XmlSources.h"
#include "xabsl/language/Parser.h"
#include "xabsl/language/Utf8.h"

namespace xabsl {

namespace {

std::string normal(const std::filesystem::path& path) {
  return path.lexically_normal().generic_string();
}

/// True if there is no character that only other kinds of files hold. Otherwise each of them would
/// be an error of its own.
bool isText(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' &&
           std::string_view("\t\n\v\f\r").find(c) == std::string_view::npos;
  });
}

/// The path of what a file includes.
std::string target(const std::string& path, const syntax::Include& include) {
  std::string name(include.path);
  std::replace(name.begin(), name.end(), '\\', '/');  // as written on Windows
  return normal(std::filesystem::path(path).parent_path() / name);
}

std::optional<std::string> toText(std::string& text) {
  if (!isText(text)) return "this is no text file";
  text = toUtf8(std::move(text));
  return std::nullopt;
}

/// Follows the includes in a loop: a chain of them may be long or closed.
void readText(const std::string& root, SourceFiles files, syntax::Program& program,
              Reporter& reporter) {
  files.open(root, toText, nullptr);
  for (std::size_t i = 0; i < program.files.size() && !reporter.full(); ++i) {
    const auto [path, text] = std::pair(program.files[i].path, program.files[i].text);
    Parser(static_cast<int>(i), text, reporter, program).parse();
    const std::vector<syntax::Include> includes = program.files[i].includes;
    for (const syntax::Include& include : includes) {
      const std::string included = target(path, include);
      const syntax::Include shown{included, include.location};
      if (!reporter.full()) files.open(included, toText, &shown);
    }
  }
}

}  // namespace

std::optional<std::string> readFile(const std::string& path, std::string& text,
                                    std::size_t largest) {
  std::error_code error;
  // A pipe or a device may never end.
  if (!std::filesystem::is_regular_file(path, error)) return "cannot open the file";
  if (std::filesystem::file_size(path, error) > largest || error)
    return "the file is larger than " + std::to_string(largest >> 20) + " MiB";
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return "cannot open the file";
  text.assign(std::istreambuf_iterator<char>(stream), {});
  return std::nullopt;
}

FileReader diskReader() {
  return [](const std::string& path, std::string& text) { return readFile(path, text); };
}

FileReader readerOf(const VirtualFiles& files) {
  return [&files](const std::string& path, std::string& text) -> std::optional<std::string> {
    const auto found = files.find(path);
    if (found == files.end()) return "there is no such file";
    if (found->second.size() > largestFile) return "the file is larger than 2 MiB";
    text = found->second;
    return std::nullopt;
  };
}

std::optional<std::string> SourceFiles::read(const std::string& path, std::string& text) {
  const std::optional<std::string> problem = read_(path, text);
  sum_ += text.size();
  if (problem || sum_ <= largestSum) return problem;
  return "the files are larger than 8 MiB together";
}

void SourceFiles::refuse(const syntax::Include& include, const std::string& why) {
  reporter_.error(include.location, "cannot include '" + std::string(include.path) + "': " + why);
}

int SourceFiles::open(const std::string& path, ToSource toSource, const syntax::Include* include) {
  const bool full = indices_.size() >= mostFiles;
  const auto [index, added] = indices_.emplace(path, -1);
  if (!added) return index->second;
  std::string text;
  std::optional<std::string> problem = full ? "more than 10000 files" : read(path, text);
  if (!problem) problem = toSource(text);
  if (!problem) {
    const std::string_view kept = program_.keep(std::move(text));
    index->second = reporter_.addFile(path, kept);
    program_.files.push_back({path, kept, {}, {}});
  } else if (include) {
    refuse(*include, *problem);
  } else {
    reporter_.fileError(path, *problem);
  }
  return index->second;
}

void readSources(const std::string& path, const FileReader& read, syntax::Program& program,
                 Reporter& reporter) {
  std::string first;
  SourceFiles sources(read, program, reporter);
  if (read(normal(path), first) || !xml::isXml(first))
    return readText(normal(path), std::move(sources), program, reporter);
  const xml::Files files = xml::readFiles(normal(path), std::move(sources), program, reporter);
  if (!reporter.failed()) xml::validate(files, reporter);
  if (!reporter.failed()) xml::Parser(files, reporter, program).parse();
}

void requireAgents(const syntax::Program& program, Reporter& reporter) {
  if (!reporter.failed() && program.agents.empty())
    reporter.error({}, "there is no agent, expected 'agent name(\"title\", root_option);'");
}

}  // namespace xabsl
