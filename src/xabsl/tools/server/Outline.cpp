#include <algorithm>
#include <optional>
#include <utility>

#include "xabsl/formats/xml/XmlReader.h"
#include "xabsl/language/Lexer.h"
#include "xabsl/language/Text.h"
#include "xabsl/tools/server/Protocol.h"
#include "xabsl/tools/server/Server.h"
#include "xabsl/tools/server/Uri.h"
#include "xabsl/tools/server/XmlScan.h"

namespace xabsl::server {

using Json = nlohmann::json;

namespace {

/// The SymbolKind of the declaration in an XML element; empty if it declares nothing.
std::optional<int> symbolKindOf(std::string_view element) {
  if (element == "option") return 5;
  if (element == "state") return 24;
  if (element == "symbols" || element == "basic-behaviors") return 3;
  if (element == "basic-behavior") return 12;
  if (element == "agent") return 19;
  if (element == "enumeration") return 10;
  if (element == "constant") return 14;
  const bool isSymbol = element.ends_with("-symbol") && !element.starts_with("set-");
  if (isSymbol || element == "decimal-input-function") return 13;
  return std::nullopt;
}

/// The outline of a behavior in XML, by its tags, which show more than its elements while the text
/// is being typed.
Json outlineOfXml(std::string_view text) {
  const Lines lines{text};
  const std::vector<ScannedElement> elements = scanXml(text).elements;
  // Of each element, and at last of the text: those that have an entry, the last one first.
  std::vector<std::vector<Json>> within(elements.size() + 1);
  std::vector<std::size_t> around(elements.size(), elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (elements[i].parent >= 0) {
      const std::size_t parent = at(elements[i].parent);
      around[i] = symbolKindOf(elements[parent].name) ? parent : around[parent];
    }
  const auto entries = [&](std::size_t i) {
    return Json(Json::array_t(within[i].rbegin(), within[i].rend()));
  };
  for (std::size_t i = elements.size(); i-- > 0;) {
    const ScannedElement& element = elements[i];
    const auto kind = symbolKindOf(element.name);
    if (!kind) continue;
    const std::string label{element.label};
    const std::size_t labelEnd = element.labelAt + label.size();
    within[around[i]].push_back(
        {{"name", label.empty() ? "<" + std::string{element.name} + ">" : label},
         {"kind", *kind},
         {"range", range(lines.position(element.begin), lines.position(element.end))},
         {"selectionRange", range(lines.position(element.labelAt), lines.position(labelEnd))},
         {"children", entries(i)}});
    within[i].clear();
  }
  return entries(elements.size());
}

/// Folds of whole lines.
class Folds {
 public:
  void add(int first, int last, const char* kind = nullptr) {
    if (last <= first) return;
    Json fold = {{"startLine", first}, {"endLine", last}};
    if (kind) fold["kind"] = kind;
    all_.push_back(std::move(fold));
  }
  Json take() { return std::move(all_); }

 private:
  Json all_ = Json::array();
};

/// Folds consecutive lines of one kind together.
class Run {
 public:
  Run(Folds& folds, const char* kind) : folds_(folds), kind_(kind) {}

  void add(int line) {
    if (line != last_ + 1) {
      end();
      first_ = line;
    }
    last_ = line;
  }
  void end() { folds_.add(first_, last_, kind_); }

 private:
  Folds& folds_;
  const char* kind_;
  int first_ = 0, last_ = -2;
};

/// The folds of blocks without their last line, of comments, and of includes.
Json foldsOfText(const std::string& text) {
  using Kind = syntax::Comment::Kind;
  const Lines lines{text};
  Reporter reporter;
  std::vector<syntax::Comment> comments;
  Lexer lexer(reporter.addFile("", text), text, reporter, &comments);
  Folds folds;
  std::vector<int> open;  // lines with an open brace
  Run includes{folds, "imports"}, notes{folds, "comment"};
  for (Token token = lexer.next(); token.kind != TokenKind::end; token = lexer.next()) {
    const int line = token.location.line - 1;
    if (token.is("include")) includes.add(line);
    if (token.is("{")) open.push_back(line);
    if (!token.is("}") || open.empty()) continue;
    folds.add(open.back(), line - 1);
    open.pop_back();
  }
  for (const syntax::Comment& comment : comments)
    if (const int line = comment.extent.begin.line - 1; comment.kind != Kind::line)
      folds.add(line, comment.extent.end.line - 1, "comment");
    else if (trimmed(lines.line(line)).starts_with("//"))
      notes.add(line);
  includes.end();
  notes.end();
  return folds.take();
}

Json foldsOfXml(std::string_view text) {
  const Lines lines{text};
  const XmlScan scan = scanXml(text);
  const auto line = [&](std::size_t place) { return lines.position(place).line; };
  Folds folds;
  for (const ScannedElement& element : scan.elements)
    folds.add(line(element.begin), line(element.end) - 1);
  for (const XmlScan::Part& comment : scan.comments)
    folds.add(line(comment.begin), line(comment.end), "comment");
  return folds.take();
}

}  // namespace

Json Server::documentSymbols(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  std::string text;
  if (reader()(path, text)) return Json::array();
  if (xml::isXml(text)) return isOfBehavior(path, text) ? outlineOfXml(text) : Json::array();
  const Project& project = projectOf(path);
  const int file = project.file(path);
  Json result = Json::array();
  if (file < 0) return result;
  const Lines& lines = project.lines(file);
  // While one types, a declaration may have no name yet.
  const auto symbol = [&](const syntax::Declaration& declaration, int kind, const char* word) {
    Location end = declaration.name.location;
    end.column += static_cast<int>(declaration.name.text.size());
    const Position begin = lines.position(declaration.name.location);
    const std::string name{declaration.name.text};
    return Json{{"name", name.empty() ? "<" + std::string{word} + ">" : name},
                {"kind", kind},
                {"range", range(lines.position(declaration.extent.begin),
                                lines.position(declaration.extent.end))},
                {"selectionRange", range(begin, lines.position(end))},
                {"children", Json::array()}};
  };
  const auto addAll = [&](const auto& list, int kind, int space, Json& to) {
    for (const auto& declaration : list)
      if (declaration.name.location.file == file && declaration.space == space)
        to.push_back(symbol(declaration, kind, ""));
  };
  const syntax::Program& program = project.program();
  for (std::size_t i = 0; i < program.namespaces.size(); ++i) {
    if (program.namespaces[i].name.location.file != file) continue;
    Json space = symbol(program.namespaces[i], 3, "namespace");
    const int index = static_cast<int>(i);
    addAll(program.enumerations, 10, index, space["children"]);
    addAll(program.symbols, 13, index, space["children"]);
    addAll(program.constants, 14, index, space["children"]);
    addAll(program.behaviors, 12, index, space["children"]);
    result.push_back(std::move(space));
  }
  for (const syntax::Option& option : program.options) {
    if (option.name.location.file != file) continue;
    Json entry = symbol(option, 5, "option");
    for (const syntax::State& state : option.states)
      entry["children"].push_back(symbol(state, 24, "state"));
    result.push_back(std::move(entry));
  }
  addAll(program.agents, 19, -1, result);
  const auto begin = [](const Json& entry) {
    const Json& start = entry["range"]["start"];
    return std::pair{start["line"].get<int>(), start["character"].get<int>()};
  };
  std::sort(result.begin(), result.end(),
            [&](const Json& a, const Json& b) { return begin(a) < begin(b); });
  return result;
}

Json Server::foldingRanges(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  std::string text;
  if (reader()(path, text)) return Json::array();
  if (!xml::isXml(text)) return foldsOfText(text);
  return isOfBehavior(path, text) ? foldsOfXml(text) : Json::array();
}

}  // namespace xabsl::server
