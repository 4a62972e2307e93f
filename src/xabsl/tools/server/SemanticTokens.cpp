#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "xabsl/tools/server/Protocol.h"
#include "xabsl/tools/server/Server.h"
#include "xabsl/tools/server/Uri.h"

namespace xabsl::server {

using Json = nlohmann::json;

namespace {

/// Standard types and modifiers of LSP, which editors support without configuration.
constexpr std::array<std::string_view, 9> tokenTypes = {"namespace", "enum",     "enumMember",
                                                        "variable",  "function", "class",
                                                        "event",     "type",     "parameter"};
constexpr std::array<std::string_view, 2> tokenModifiers = {"declaration", "readonly"};
constexpr int declares = 1, isReadOnly = 2;

std::string_view tokenTypeOf(Entity::Kind kind) {
  switch (kind) {
    case Entity::Kind::space:
      return "namespace";
    case Entity::Kind::enumeration:
      return "enum";
    case Entity::Kind::element:
      return "enumMember";
    case Entity::Kind::symbol:
    case Entity::Kind::constant:
      return "variable";
    case Entity::Kind::behavior:
      return "function";
    case Entity::Kind::option:
      return "class";
    case Entity::Kind::state:
      return "event";
    case Entity::Kind::agent:
      return "type";
    default:
      return "parameter";
  }
}

/// Whether a behavior cannot set an entity: it is a constant or an input symbol.
bool cannotBeSet(const Project& project, const Entity& entity) {
  if (entity.kind == Entity::Kind::constant) return true;
  const auto& symbols = project.program().symbols;
  return entity.kind == Entity::Kind::symbol && at(entity.index) < symbols.size() &&
         symbols[at(entity.index)].kind == SymbolKind::input;
}

}  // namespace

Json semanticLegend() {
  return {{"tokenTypes", tokenTypes}, {"tokenModifiers", tokenModifiers}};
}

/// Returns the meaning of each name, which its spelling does not show; five numbers per name.
Json Server::semanticTokens(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  const Project& project = projectOf(path);
  const int file = project.file(path);
  Json data = Json::array();
  if (file < 0) return {{"data", std::move(data)}};
  std::vector<const Reference*> names;
  for (const Reference& reference : project.references())
    if (reference.location.file == file) names.push_back(&reference);
  std::ranges::sort(names, {}, [](const Reference* r) {
    return std::pair{r->location.line, r->location.column};
  });
  Position last, lastEnd;
  for (const Reference* name : names) {
    const Lines& lines = project.lines(file);
    Location behind = name->location;
    behind.column += static_cast<int>(name->text.size());
    const Position begin = lines.position(name->location), end = lines.position(behind);
    // Names do not overlap for editors; in XML one may stand for two things.
    if (begin.line == lastEnd.line && begin.character < lastEnd.character) continue;
    if (end.character <= begin.character) continue;
    const bool sameLine = begin.line == last.line;
    const auto type = std::ranges::find(tokenTypes, tokenTypeOf(name->entity.kind));
    for (const int number :
         {begin.line - last.line, sameLine ? begin.character - last.character : begin.character,
          end.character - begin.character, static_cast<int>(type - tokenTypes.begin()),
          (name->declares ? declares : 0) | (cannotBeSet(project, name->entity) ? isReadOnly : 0)})
      data.push_back(number);
    last = begin;
    lastEnd = end;
  }
  return {{"data", std::move(data)}};
}

}  // namespace xabsl::server
