#include "xabsl/tools/server/Server.h"

#include <algorithm>
#include <utility>

#include "base/ParseJson.h"
#include "xabsl/formats/xml/XmlReader.h"
#include "xabsl/language/SourceFiles.h"
#include "xabsl/language/Text.h"
#include "xabsl/language/Utf8.h"
#include "xabsl/tools/server/Protocol.h"
#include "xabsl/tools/server/Uri.h"

namespace xabsl::server {

using Json = nlohmann::json;

namespace {

constexpr std::size_t mostDocuments = 1000;

/// Whether a text is XML of another language, for which nothing is reported.
bool isForeign(const std::string& text) {
  return xml::isXml(text) && text.find(xml::namespace21) == std::string::npos &&
         text.find(xml::namespace31) == std::string::npos;
}

/// The end of the word at a place, for underlining.
Location wordEnd(std::string_view line, Location location) {
  std::size_t i = 0;
  int column = 1;
  for (; i < line.size() && column < location.column; ++i)
    if (i + 1 >= line.size() || !continuesLetter(line[i + 1])) ++column;
  const int first = location.column;
  for (; i < line.size() && isNamePart(line[i]); ++i) ++location.column;
  if (location.column == first) ++location.column;
  return location;
}

}  // namespace

Server::Server(Disk disk, Send send) : disk_(std::move(disk)), send_(std::move(send)) {}
Server::~Server() = default;

void Server::send(const Json& message) {
  // Files may hold bytes that are no UTF-8.
  send_(message.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Server::handle(std::string_view text) {
  const auto message = gt::parseJsonAs<Json>(text, "");
  if (message && message->is_object()) return dispatch(*message);
  const int code = message ? invalidRequest : parseError;
  const std::string why = message ? "no message of JSON-RPC" : "the text " + message.error().what;
  send({{"jsonrpc", "2.0"}, {"id", nullptr}, {"error", {{"code", code}, {"message", why}}}});
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
    Json result = request(method->get<std::string>(), parameters);
    if (!refusal_) answer["result"] = std::move(result);
  } catch (const Json::exception&) {
    refuse(invalidParameters, "these are no parameters of " + method->get<std::string>());
  }
  if (const auto refusal = std::exchange(refusal_, std::nullopt))
    answer["error"] = {{"code", refusal->code}, {"message", refusal->message}};
  send(answer);
}

Server::Json Server::refuse(int code, std::string message) {
  refusal_ = Refusal{code, std::move(message)};
  return nullptr;
}

void Server::notify(const std::string& method, const Json& parameters) {
  if (method == "exit") ended_ = true;
  if (!initialized_ || shutDown_) return;
  if (method == "textDocument/didOpen") {
    const Json& document = parameters.at("textDocument");
    open(document.at("uri").get<std::string>(), document.at("text").get<std::string>());
  } else if (method == "textDocument/didChange") {
    change(parameters.at("textDocument").at("uri").get<std::string>(),
           parameters.at("contentChanges"));
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
      {"textDocument/foldingRange", &Server::foldingRanges},
      {"textDocument/semanticTokens/full", &Server::semanticTokens},
      {"textDocument/formatting", &Server::formatting}};
  if (shutDown_) return refuse(invalidRequest, "the server is shut down");
  if (method == "initialize") return initialize(parameters);
  if (!initialized_) return refuse(notInitialized, "the server is not initialized");
  if (method == "shutdown") {
    shutDown_ = true;
    return nullptr;
  }
  const auto handler = handlers.find(method);
  if (handler == handlers.end()) return refuse(methodNotFound, "unknown method " + method);
  return (this->*handler->second)(parameters);
}

Json Server::initialize(const Json& parameters) {
  if (initialized_) return refuse(invalidRequest, "the server is initialized already");
  if (const auto root = parameters.find("rootUri"); root != parameters.end() && root->is_string())
    workspace_ = pathOf(root->get<std::string>());
  if (const auto id = parameters.find("processId");
      id != parameters.end() && id->is_number_unsigned())
    editor_ = id->get<std::int64_t>();
  initialized_ = true;
  return {{"capabilities",
           {{"positionEncoding", "utf-16"},
            {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
            {"completionProvider", {{"triggerCharacters", {"@", "(", "=", " "}}}},
            {"signatureHelpProvider", {{"triggerCharacters", {"(", ","}}}},
            {"definitionProvider", true},
            {"referencesProvider", true},
            {"documentHighlightProvider", true},
            {"hoverProvider", true},
            {"renameProvider", {{"prepareProvider", true}}},
            {"documentSymbolProvider", true},
            {"foldingRangeProvider", true},
            {"semanticTokensProvider", {{"legend", semanticLegend()}, {"full", true}}},
            {"documentFormattingProvider", true}}},
          {"serverInfo", {{"name", "xabsl"}}}};
}

void Server::open(const std::string& uri, const std::string& text) {
  const std::string path = pathOf(uri);
  if (documents_.size() >= mostDocuments && documents_.count(path) == 0) return;
  if (documents_.count(path) == 0) roots_.erase(path);
  documents_[path] = text;
  std::string& spelled = uris_[path];
  if (!spelled.empty() && spelled != uri) sendDiagnostics(spelled, Json::array());
  spelled = uri;
  projects_.clear();
  changed_ = true;
}

/// Each change replaces a range of the text that results from the change before, or the whole text.
void Server::change(const std::string& uri, const Json& changes) {
  const auto known = documents_.find(pathOf(uri));
  std::optional<std::string> text;
  if (known != documents_.end()) text = known->second;
  for (const Json& one : changes) {
    const std::string& inserted = one.at("text").get_ref<const std::string&>();
    const auto range = one.find("range");
    if (range == one.end()) {
      text = inserted;
    } else if (text) {
      const Lines lines{*text};
      const std::size_t begin = lines.offset(positionOf(range->at("start"))),
                        end = lines.offset(positionOf(range->at("end")));
      text->replace(begin, std::max(begin, end) - begin, inserted);
    }
  }
  if (text && !changes.empty()) open(uri, *text);
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

/// The file with the agents that includes a file, within the workspace; the file itself if there is
/// none.
std::string Server::rootOf(const std::string& path) {
  const auto [known, isNew] = roots_.try_emplace(path);
  if (isNew) {
    known->second = xabsl::rootOf(path, disk_.sources, reader(), workspace_);
    if (known->second.empty()) known->second = path;
  }
  return known->second;
}

/// Whether a file belongs to a behavior, because XML may be in any language.
bool Server::isOfBehavior(const std::string& path, const std::string& text) {
  return !isForeign(text) || rootOf(path) != path;
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
    sendDiagnostics(uriOf(path), diagnostics);
  }
}

void Server::sendDiagnostics(const std::string& uri, const Json& diagnostics) {
  send({{"jsonrpc", "2.0"},
        {"method", "textDocument/publishDiagnostics"},
        {"params", {{"uri", uri}, {"diagnostics", diagnostics}}}});
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

}  // namespace xabsl::server
