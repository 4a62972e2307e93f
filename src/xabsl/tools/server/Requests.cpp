#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "xabsl/formats/text/Formatter.h"
#include "xabsl/language/Lexer.h"
#include "xabsl/tools/server/Protocol.h"
#include "xabsl/tools/server/Server.h"
#include "xabsl/tools/server/Uri.h"

namespace xabsl::server {

using Json = nlohmann::json;

namespace {

int kindOf(Completion::Kind kind) {  // CompletionItemKind
  switch (kind) {
    case Completion::Kind::keyword:
      return 14;
    case Completion::Kind::option:
      return 7;
    case Completion::Kind::behavior:
      return 3;
    case Completion::Kind::symbol:
      return 6;
    case Completion::Kind::constant:
      return 21;
    case Completion::Kind::element:
      return 20;
    case Completion::Kind::enumeration:
      return 13;
    case Completion::Kind::state:
      return 12;
    default:
      return 10;
  }
}

}  // namespace

/// The place of a request: the project, and the name there, if there is one.
struct Server::Place {
  Project& project;
  const Reference* reference;
};

Server::Place Server::placeOf(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  Project& project = projectOf(path);
  const int file = project.file(path);
  if (file < 0) return {project, nullptr};
  return {project,
          project.at(project.lines(file).location(positionOf(parameters.at("position")), file))};
}

Json Server::rangeOf(const Project& project, const Reference& reference) const {
  const Lines& lines = project.lines(reference.location.file);
  Location end = reference.location;
  end.column += static_cast<int>(reference.text.size());
  return range(lines.position(reference.location), lines.position(end));
}

Json Server::locationOf(const Project& project, const Reference& reference) const {
  const std::string& path = project.program().files[at(reference.location.file)].path;
  return {{"uri", uriOf(path)}, {"range", rangeOf(project, reference)}};
}

Json Server::completion(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  std::string text;
  if (reader()(path, text)) return Json::array();
  Json items = Json::array();
  for (const Completion& completion :
       complete(projectOf(path), text, Lines(text).offset(positionOf(parameters.at("position"))))) {
    Json item = {{"label", completion.name},
                 {"kind", kindOf(completion.kind)},
                 {"insertText", completion.insert}};
    if (!completion.detail.empty()) item["detail"] = completion.detail;
    if (!completion.doc.empty()) item["documentation"] = completion.doc;
    items.push_back(std::move(item));
  }
  return items;
}

Json Server::signatureHelp(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  std::string text;
  if (reader()(path, text)) return nullptr;
  const std::optional<Signature> signature =
      signatureAt(projectOf(path), text, Lines(text).offset(positionOf(parameters.at("position"))));
  if (!signature) return nullptr;
  Json labels = Json::array();
  for (const Signature::Parameter& parameter : signature->parameters)
    labels.push_back({{"label", parameter.label}, {"documentation", parameter.doc}});
  return {
      {"signatures",
       {{{"label", signature->label}, {"documentation", signature->doc}, {"parameters", labels}}}},
      {"activeSignature", 0},
      {"activeParameter", signature->active}};
}

Json Server::definition(const Json& parameters) {
  const Place place = placeOf(parameters);
  if (!place.reference) return nullptr;
  const Reference* declaration = place.project.declaration(place.reference->entity);
  return declaration ? locationOf(place.project, *declaration) : Json();
}

Json Server::referencesOf(const Json& parameters) {
  const Place place = placeOf(parameters);
  const bool declarations = parameters.at("context").at("includeDeclaration").get<bool>();
  Json result = Json::array();
  if (!place.reference) return result;
  for (const Reference& reference : place.project.references())
    if (reference.entity == place.reference->entity && (declarations || !reference.declares))
      result.push_back(locationOf(place.project, reference));
  return result;
}

Json Server::highlights(const Json& parameters) {
  const Place place = placeOf(parameters);
  Json result = Json::array();
  if (!place.reference) return result;
  for (const Reference& reference : place.project.references())
    if (reference.entity == place.reference->entity &&
        reference.location.file == place.reference->location.file)
      result.push_back({{"range", rangeOf(place.project, reference)}});
  return result;
}

Json Server::hover(const Json& parameters) {
  const Place place = placeOf(parameters);
  const std::string text =
      place.reference ? describeEntity(place.project, place.reference->entity) : "";
  if (text.empty()) return nullptr;
  return {{"contents", {{"kind", "markdown"}, {"value", text}}},
          {"range", rangeOf(place.project, *place.reference)}};
}

Json Server::prepareRename(const Json& parameters) {
  const Place place = placeOf(parameters);
  if (!place.reference) return nullptr;
  Json range = rangeOf(place.project, *place.reference);
  if (place.project.isMarked(*place.reference)) {
    Json& begin = range["start"]["character"];
    begin = begin.get<int>() - 1;
  }
  return range;
}

/// Renames all places at once, and only if all of them are known: the behavior must have no errors
/// before and after it.
Json Server::rename(const Json& parameters) {
  const Place place = placeOf(parameters);
  std::string name = parameters.at("newName").get<std::string>();
  if (place.project.failed())
    return refuse(requestFailed, "the behavior has errors, mend them first");
  if (!place.reference) return refuse(requestFailed, "there is no name here");
  const Entity entity = place.reference->entity;
  if (entity.kind == Entity::Kind::optionParameter && name.starts_with('@')) name.erase(0, 1);
  Reporter reporter;
  Lexer lexer(reporter.addFile(""), name, reporter);
  const Token token = lexer.next();
  if (token.kind != TokenKind::identifier || token.text != name ||
      lexer.next().kind != TokenKind::end || reporter.failed())
    return refuse(requestFailed, inQuotes(name) + " is no name");

  std::map<std::string, std::string> texts;
  Json changes = Json::object();
  std::vector<const Reference*> places;
  for (const Reference& reference : place.project.references())
    if (reference.entity == entity) places.push_back(&reference);
  // The last first, so that the others stay where they are.
  std::ranges::sort(places, std::ranges::greater{}, [](const Reference* reference) {
    const Location& place = reference->location;
    return std::tuple{place.file, place.line, place.column};
  });
  for (const Reference* reference : places) {
    const syntax::File& file = place.project.program().files[at(reference->location.file)];
    std::string& text = texts.emplace(file.path, file.text).first->second;
    const Lines& lines = place.project.lines(reference->location.file);
    const std::size_t offset = lines.offset(lines.position(reference->location));
    // In XML a name may be written with blanks around it, or with entities.
    if (text.compare(offset, reference->text.size(), reference->text) != 0)
      return refuse(requestFailed, inQuotes(reference->text) + " is written otherwise in " +
                                       file.path + ":" + std::to_string(reference->location.line));
    text.replace(offset, reference->text.size(), name);
    changes[uriOf(file.path)].push_back(
        {{"range", rangeOf(place.project, *reference)}, {"newText", name}});
  }
  const Project renamed(
      place.project.root(),
      [&](const std::string& path, std::string& text) -> std::optional<std::string> {
        const auto changed = texts.find(path);
        if (changed == texts.end()) return reader()(path, text);
        text = changed->second;
        return std::nullopt;
      });
  for (const Diagnostic& diagnostic : renamed.diagnostics())
    if (diagnostic.severity == Diagnostic::Severity::error)
      return refuse(requestFailed, diagnostic.message);
  return {{"changes", changes}};
}

Json Server::formatting(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  std::string text;
  if (const auto problem = reader()(path, text)) return refuse(requestFailed, *problem);
  Reporter reporter;
  const std::optional<std::string> formatted = format(reporter.addFile(path, text), text, reporter);
  if (!formatted) return refuse(requestFailed, "the file holds what is no word of XABSL");
  if (*formatted == text) return Json::array();
  return Json::array({{{"range", range({}, Lines(text).end())}, {"newText", *formatted}}});
}

}  // namespace xabsl::server
