#include "xabsl/formats/Sources.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "xabsl/formats/xml/XmlParser.h"
#include "xabsl/formats/xml/XmlReader.h"
#include "xabsl/formats/xml/XmlSchema.h"
#include "xabsl/formats/xml/XmlSources.h"
#include "xabsl/language/Parser.h"
#include "xabsl/language/SourceFiles.h"
#include "xabsl/language/Utf8.h"

namespace xabsl {

namespace {

std::string normal(const std::filesystem::path& path) {
  return path.lexically_normal().generic_string();
}

/// True if a text contains no characters of binary files. Otherwise each of them would be a
/// separate error.
bool isText(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' &&
           std::string_view("\t\n\v\f\r").find(c) == std::string_view::npos;
  });
}

/// The path of an included file.
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
