#include "xabsl/server/Server.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <tuple>
#include <utility>

#include "xabsl/Formatter.h"
#include "xabsl/Lexer.h"
#include "xabsl/XmlReader.h"
#include "xabsl/server/Uri.h"

namespace xabsl::server {

using Json = nlohmann::json;

namespace {

constexpr int invalidRequest = -32600, methodNotFound = -32601, invalidParameters = -32602,
              parseError = -32700, notInitialized = -32002, requestFailed = -32803;
constexpr std::size_t mostDocuments = 1000;

/// An answer that tells why there is no other.
struct Refusal {
  int code;
  std::string message;
};

Json json(Position position) {
  return {{"line", position.line}, {"character", position.character}};
}

Json range(Position begin, Position end) {
  return {{"start", json(begin)}, {"end", json(end)}};
}

Position positionOf(const Json& parameters) {
  const Json& position = parameters.at("position");
  return {position.at("line").get<int>(), position.at("character").get<int>()};
}

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

bool isBefore(Location a, Location b) {
  return std::tie(a.line, a.column) < std::tie(b.line, b.column);
}

/// Whether a text is XML of another language, of which nothing is told.
bool isForeign(const std::string& text) {
  return xml::isXml(text) && text.find(xml::namespace21) == std::string::npos &&
         text.find(xml::namespace31) == std::string::npos;
}

/// Whether a file may be that with the agents of another one.
bool mayBeRootOf(const std::string& candidate, const std::string& text, const std::string& path) {
  const std::filesystem::path extension = std::filesystem::path(candidate).extension();
  return extension == std::filesystem::path(path).extension() &&
         text.find(extension == ".xml" ? "<agent-collection" : "agent") != std::string::npos;
}

/// The end of the word at a place, for what is underlined.
Location wordEnd(std::string_view line, Location location) {
  const auto inWord = [](char c) {
    return c == '_' || c == '.' || (c >= '0' && c <= '9') ||
           ((c | 0x20) >= 'a' && (c | 0x20) <= 'z');
  };
  std::size_t i = 0;
  int column = 1;
  const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) == 0x80u; };
  for (; i < line.size() && column < location.column; ++i)
    if (i + 1 >= line.size() || !continues(line[i + 1])) ++column;
  const int first = location.column;
  for (; i < line.size() && inWord(line[i]); ++i) ++location.column;
  if (location.column == first) ++location.column;
  return location;
}

}  // namespace

/// Where a request points: the project, and what is named there, if anything is.
struct Server::Place {
  Project& project;
  const Reference* reference;

  const Entity& entity() const {
    if (!reference) throw Refusal{requestFailed, "there is no name here"};
    return reference->entity;
  }
};

Server::Server(Disk disk, Send send) : disk_(std::move(disk)), send_(std::move(send)) {}
Server::~Server() = default;

void Server::send(const Json& message) {
  // Files may hold bytes that are no UTF-8.
  send_(message.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Server::handle(std::string_view text) {
  const Json message = Json::parse(text, nullptr, false);
  if (message.is_object()) return dispatch(message);
  const int code = message.is_discarded() ? parseError : invalidRequest;
  send({{"jsonrpc", "2.0"},
        {"id", nullptr},
        {"error", {{"code", code}, {"message", "no message of JSON-RPC"}}}});
}

void Server::dispatch(const Json& message) {
  const auto method = message.find("method");
  const auto id = message.find("id");
  const bool named = method != message.end() && method->is_string();
  const Json parameters = message.value("params", Json::object());
  if (id == message.end()) {
    try {
      if (named) notify(method->get<std::string>(), parameters);
    } catch (const Json::exception&) {
      // A notification has no answer, so a broken one is put aside.
    }
    return;
  }
  if (!named) return;  // an answer; this server asks nothing
  Json answer = {{"jsonrpc", "2.0"}, {"id", id->is_string() || id->is_number() ? *id : Json()}};
  try {
    answer["result"] = request(method->get<std::string>(), parameters);
  } catch (const Json::exception& error) {
    answer["error"] = {{"code", invalidParameters}, {"message", error.what()}};
  } catch (const Refusal& refusal) {
    answer["error"] = {{"code", refusal.code}, {"message", refusal.message}};
  }
  send(answer);
}

void Server::notify(const std::string& method, const Json& parameters) {
  if (method == "exit") ended_ = true;
  if (!initialized_ || shutDown_) return;
  if (method == "textDocument/didOpen") {
    const Json& document = parameters.at("textDocument");
    open(document.at("uri").get<std::string>(), document.at("text").get<std::string>());
  } else if (method == "textDocument/didChange") {
    const Json& changes = parameters.at("contentChanges");
    if (!changes.empty())
      open(parameters.at("textDocument").at("uri").get<std::string>(),
           changes.back().at("text").get<std::string>());
  } else if (method == "textDocument/didClose") {
    close(parameters.at("textDocument").at("uri").get<std::string>());
  } else if (method == "workspace/didChangeWatchedFiles" || method == "textDocument/didSave") {
    projects_.clear();
    roots_.clear();
    changed_ = true;
  }
}

Json Server::request(const std::string& method, const Json& parameters) {
  using Handler = Json (Server::*)(const Json&);
  static const std::map<std::string, Handler> handlers = {
      {"textDocument/completion", &Server::completion},
      {"textDocument/signatureHelp", &Server::signatureHelp},
      {"textDocument/definition", &Server::definition},
      {"textDocument/references", &Server::referencesOf},
      {"textDocument/documentHighlight", &Server::highlights},
      {"textDocument/hover", &Server::hover},
      {"textDocument/prepareRename", &Server::prepareRename},
      {"textDocument/rename", &Server::rename},
      {"textDocument/documentSymbol", &Server::documentSymbols},
      {"textDocument/formatting", &Server::formatting}};
  if (shutDown_) throw Refusal{invalidRequest, "the server is shut down"};
  if (method == "initialize") return initialize(parameters);
  if (!initialized_) throw Refusal{notInitialized, "the server is not initialized"};
  if (method == "shutdown") {
    shutDown_ = true;
    return nullptr;
  }
  const auto handler = handlers.find(method);
  if (handler == handlers.end()) throw Refusal{methodNotFound, "unknown method " + method};
  return (this->*handler->second)(parameters);
}

Json Server::initialize(const Json& parameters) {
  if (initialized_) throw Refusal{invalidRequest, "the server is initialized already"};
  if (const auto root = parameters.find("rootUri"); root != parameters.end() && root->is_string())
    workspace_ = pathOf(root->get<std::string>());
  initialized_ = true;
  return {{"capabilities",
           {{"positionEncoding", "utf-16"},
            {"textDocumentSync", {{"openClose", true}, {"change", 1}, {"save", true}}},
            {"completionProvider", {{"triggerCharacters", {"@", "(", "=", " "}}}},
            {"signatureHelpProvider", {{"triggerCharacters", {"(", ","}}}},
            {"definitionProvider", true},
            {"referencesProvider", true},
            {"documentHighlightProvider", true},
            {"hoverProvider", true},
            {"renameProvider", {{"prepareProvider", true}}},
            {"documentSymbolProvider", true},
            {"documentFormattingProvider", true}}},
          {"serverInfo", {{"name", "xabsl"}}}};
}

void Server::open(const std::string& uri, const std::string& text) {
  const std::string path = pathOf(uri);
  if (documents_.size() >= mostDocuments && documents_.count(path) == 0) return;
  if (documents_.count(path) == 0) roots_.erase(path);
  documents_[path] = text;
  uris_[path] = uri;
  projects_.clear();
  changed_ = true;
}

void Server::close(const std::string& uri) {
  const std::string path = pathOf(uri);
  documents_.erase(path);
  uris_.erase(path);
  roots_.clear();
  projects_.clear();
  changed_ = true;
}

FileReader Server::reader() const {
  return [this](const std::string& path, std::string& text) -> std::optional<std::string> {
    const auto document = documents_.find(path);
    if (document == documents_.end()) return disk_.read(path, text);
    if (document->second.size() > largestFile) return "the file is larger than 2 MiB";
    text = document->second;
    return std::nullopt;
  };
}

/// The file with the agents that a file belongs to: beside it or in a folder above, within the
/// workspace. A file that belongs to none stands for itself.
std::string Server::rootOf(const std::string& path) {
  const auto known = roots_.find(path);
  if (known != roots_.end()) return known->second;
  constexpr int farthest = 6, mostCandidates = 200;
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  int candidates = 0;
  for (int i = 0; i < farthest; ++i, folder = folder.parent_path()) {
    for (const std::string& candidate : disk_.sources(folder.generic_string())) {
      std::string text;
      if (++candidates > mostCandidates || reader()(candidate, text)) continue;
      if (!mayBeRootOf(candidate, text, path)) continue;
      Reporter ignored;
      syntax::Program program;
      readSources(candidate, reader(), program, ignored);
      const bool includes =
          std::any_of(program.files.begin(), program.files.end(),
                      [&](const syntax::File& file) { return file.path == path; });
      const bool xml = xml::isXml(text);  // which has no agents as long as it is not valid
      if (includes && (xml || !program.agents.empty())) return roots_[path] = candidate;
    }
    if (folder.generic_string() == workspace_ || folder == folder.parent_path()) break;
  }
  return roots_[path] = path;
}

Project& Server::projectOf(const std::string& path) {
  const std::string root = rootOf(path);
  std::unique_ptr<Project>& project = projects_[root];
  if (!project) project = std::make_unique<Project>(root, reader());
  return *project;
}

std::string Server::uriOf(const std::string& path) const {
  const auto known = uris_.find(path);
  if (known != uris_.end()) return known->second;
  return fileUri(path);
}

void Server::publish() {
  if (!changed_) return;
  changed_ = false;
  std::map<std::string, Json> perFile;
  for (const std::string& path : published_) perFile[path] = Json::array();
  published_.clear();
  std::set<std::string> roots;
  for (const auto& [path, text] : documents_) {
    perFile.emplace(path, Json::array());
    if (isForeign(text)) continue;
    const Project& project = projectOf(path);
    if (roots.insert(project.root()).second) publishFor(project, perFile);
  }
  for (const auto& [path, diagnostics] : perFile) {
    if (!diagnostics.empty()) published_.insert(path);
    send({{"jsonrpc", "2.0"},
          {"method", "textDocument/publishDiagnostics"},
          {"params", {{"uri", uriOf(path)}, {"diagnostics", diagnostics}}}});
  }
}

void Server::publishFor(const Project& project, std::map<std::string, Json>& perFile) const {
  for (const Diagnostic& diagnostic : project.diagnostics()) {
    const int file = project.file(diagnostic.file);
    Position begin, end;
    if (file >= 0 && diagnostic.line > 0) {
      const Lines& lines = project.lines(file);
      const Location location{file, diagnostic.line, diagnostic.column};
      begin = lines.position(location);
      end = lines.position(wordEnd(lines.line(diagnostic.line - 1), location));
    }
    Json& list = perFile[diagnostic.file];
    if (list.is_null()) list = Json::array();
    list.push_back({{"range", range(begin, end)},
                    {"severity", diagnostic.severity == Diagnostic::Severity::error ? 1 : 2},
                    {"source", "xabsl"},
                    {"message", diagnostic.message}});
  }
}

Server::Place Server::placeOf(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  Project& project = projectOf(path);
  const int file = project.file(path);
  if (file < 0) return {project, nullptr};
  return {project, project.at(project.lines(file).location(positionOf(parameters), file))};
}

Json Server::rangeOf(const Project& project, const Reference& reference) const {
  const Lines& lines = project.lines(reference.location.file);
  Location end = reference.location;
  end.column += static_cast<int>(reference.text.size());
  return range(lines.position(reference.location), lines.position(end));
}

Json Server::locationOf(const Project& project, const Reference& reference) const {
  const std::string& path =
      project.program().files[static_cast<std::size_t>(reference.location.file)].path;
  return {{"uri", uriOf(path)}, {"range", rangeOf(project, reference)}};
}

Json Server::completion(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  std::string text;
  if (reader()(path, text)) return Json::array();
  Json items = Json::array();
  for (const Completion& completion :
       complete(projectOf(path), text, Lines(text).offset(positionOf(parameters)))) {
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
      signatureAt(projectOf(path), text, Lines(text).offset(positionOf(parameters)));
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
  const Reference* declaration = place.project.declaration(place.entity());
  return declaration ? locationOf(place.project, *declaration) : Json();
}

Json Server::referencesOf(const Json& parameters) {
  const Place place = placeOf(parameters);
  const bool declarations = parameters.at("context").at("includeDeclaration").get<bool>();
  Json result = Json::array();
  if (!place.reference) return result;
  for (const Reference& reference : place.project.references())
    if (reference.entity == place.entity() && (declarations || !reference.declares))
      result.push_back(locationOf(place.project, reference));
  return result;
}

Json Server::highlights(const Json& parameters) {
  const Place place = placeOf(parameters);
  Json result = Json::array();
  if (!place.reference) return result;
  for (const Reference& reference : place.project.references())
    if (reference.entity == place.entity() &&
        reference.location.file == place.reference->location.file)
      result.push_back({{"range", rangeOf(place.project, reference)}});
  return result;
}

Json Server::hover(const Json& parameters) {
  const Place place = placeOf(parameters);
  const std::string text = place.reference ? describeEntity(place.project, place.entity()) : "";
  if (text.empty()) return nullptr;
  return {{"contents", {{"kind", "markdown"}, {"value", text}}},
          {"range", rangeOf(place.project, *place.reference)}};
}

Json Server::prepareRename(const Json& parameters) {
  const Place place = placeOf(parameters);
  return place.reference ? rangeOf(place.project, *place.reference) : Json();
}

/// All places at once, and only where all of them are known: in a behavior without errors that has
/// none after it either.
Json Server::rename(const Json& parameters) {
  const Place place = placeOf(parameters);
  const std::string name = parameters.at("newName").get<std::string>();
  if (place.project.failed())
    throw Refusal{requestFailed, "the behavior has errors, mend them first"};
  const Entity entity = place.entity();
  Reporter reporter;
  Lexer lexer(reporter.addFile(""), name, reporter);
  const Token token = lexer.next();
  if (token.kind != TokenKind::identifier || token.text != name ||
      lexer.next().kind != TokenKind::end || reporter.failed())
    throw Refusal{requestFailed, "'" + name + "' is no name"};

  std::map<std::string, std::string> texts;
  Json changes = Json::object();
  std::vector<const Reference*> places;
  for (const Reference& reference : place.project.references())
    if (reference.entity == entity) places.push_back(&reference);
  std::sort(places.begin(), places.end(),
            [](const Reference* a, const Reference* b) { return a->text.data() > b->text.data(); });
  for (const Reference* reference :
       places) {  // the last first, so that the others stay where they are
    const syntax::File& file =
        place.project.program().files[static_cast<std::size_t>(reference->location.file)];
    std::string& text = texts.emplace(file.path, file.text).first->second;
    text.replace(static_cast<std::size_t>(reference->text.data() - file.text.data()),
                 reference->text.size(), name);
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
      throw Refusal{requestFailed, diagnostic.message};
  return {{"changes", changes}};
}

Json Server::documentSymbols(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  const Project& project = projectOf(path);
  const int file = project.file(path);
  Json result = Json::array();
  if (file < 0) return result;
  const Lines& lines = project.lines(file);
  const auto symbol = [&](const syntax::Declaration& declaration, int kind) {
    Location end = declaration.name.location;
    end.column += static_cast<int>(declaration.name.text.size());
    const Position begin = lines.position(declaration.name.location);
    // In XML only the begin of an element is known.
    const Location last = isBefore(declaration.extent.end, end) ? end : declaration.extent.end;
    return Json{{"name", std::string(declaration.name.text)},
                {"kind", kind},
                {"range", range(lines.position(declaration.extent.begin), lines.position(last))},
                {"selectionRange", range(begin, lines.position(end))},
                {"children", Json::array()}};
  };
  const auto addAll = [&](const auto& list, int kind, int space, Json& to) {
    for (const auto& declaration : list)
      if (declaration.name.location.file == file && declaration.space == space)
        to.push_back(symbol(declaration, kind));
  };
  const syntax::Program& program = project.program();
  for (std::size_t i = 0; i < program.namespaces.size(); ++i) {
    if (program.namespaces[i].name.location.file != file) continue;
    Json space = symbol(program.namespaces[i], 3);
    const int index = static_cast<int>(i);
    addAll(program.enumerations, 10, index, space["children"]);
    addAll(program.symbols, 13, index, space["children"]);
    addAll(program.constants, 14, index, space["children"]);
    addAll(program.behaviors, 12, index, space["children"]);
    result.push_back(std::move(space));
  }
  for (const syntax::Option& option : program.options) {
    if (option.name.location.file != file) continue;
    Json entry = symbol(option, 5);
    for (const syntax::State& state : option.states) entry["children"].push_back(symbol(state, 24));
    result.push_back(std::move(entry));
  }
  addAll(program.agents, 19, -1, result);
  return result;
}

Json Server::formatting(const Json& parameters) {
  const std::string path = pathOf(parameters.at("textDocument").at("uri").get<std::string>());
  std::string text;
  if (const auto problem = reader()(path, text)) throw Refusal{requestFailed, *problem};
  Reporter reporter;
  const std::optional<std::string> formatted = format(reporter.addFile(path, text), text, reporter);
  if (!formatted) throw Refusal{requestFailed, "the file holds what is no word of XABSL"};
  if (*formatted == text) return Json::array();
  return Json::array({{{"range", range({}, Lines(text).end())}, {"newText", *formatted}}});
}

}  // namespace xabsl::server
