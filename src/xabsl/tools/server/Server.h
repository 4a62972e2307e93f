#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/formats/Root.h"
#include "xabsl/tools/server/Project.h"

namespace xabsl::server {

/// The functions by which a server accesses the disk.
struct Disk {
  FileReader read;
  FolderLister sources;
};

/// A language server for XABSL (LSP 3.17): handles the messages of an editor one after another, and
/// sends its own. For files that are open in the editor, the editor's text is used.
class Server {
 public:
  using Send = std::function<void(const std::string& message)>;

  Server(Disk disk, Send send);
  ~Server();

  /// Handles a message. Any message is answered or ignored.
  void handle(std::string_view message);

  /// Publishes the diagnostics of changed files; called when no message is pending.
  void publish();

  bool ended() const { return ended_; }
  /// The process of the editor, if the editor has sent it. If the process has ended, nobody will
  /// end the session.
  std::optional<std::int64_t> editor() const { return editor_; }
  /// The exit status of the program: 0 after an orderly shutdown.
  int status() const { return shutDown_ ? 0 : 1; }

 private:
  using Json = nlohmann::json;
  struct Place;
  struct Refusal {
    int code;
    std::string message;
  };

  void dispatch(const Json& message);
  void notify(const std::string& method, const Json& parameters);
  Json request(const std::string& method, const Json& parameters);
  /// Answers the present request with an error instead of its result.
  Json refuse(int code, std::string message);
  Json initialize(const Json& parameters);
  void open(const std::string& uri, const std::string& text);
  void change(const std::string& uri, const Json& changes);
  void close(const std::string& uri);

  Json completion(const Json& parameters);
  Json signatureHelp(const Json& parameters);
  Json definition(const Json& parameters);
  Json referencesOf(const Json& parameters);
  Json highlights(const Json& parameters);
  Json hover(const Json& parameters);
  Json prepareRename(const Json& parameters);
  Json rename(const Json& parameters);
  Json documentSymbols(const Json& parameters);
  Json foldingRanges(const Json& parameters);
  Json semanticTokens(const Json& parameters);
  Json formatting(const Json& parameters);

  Place placeOf(const Json& parameters);
  Json rangeOf(const Project& project, const Reference& reference) const;
  Json locationOf(const Project& project, const Reference& reference) const;
  std::string uriOf(const std::string& path) const;
  Project& projectOf(const std::string& path);
  std::string rootOf(const std::string& path);
  bool isOfBehavior(const std::string& path, const std::string& text);
  FileReader reader() const;
  void publishFor(const Project& project, std::map<std::string, Json>& perFile) const;
  void sendDiagnostics(const std::string& uri, const Json& diagnostics);
  void send(const Json& message);

  Disk disk_;
  Send send_;
  std::string workspace_;
  std::map<std::string, std::string> documents_;  ///< text by path
  std::map<std::string, std::string> uris_;       ///< as the editor writes them, by path
  std::map<std::string, std::unique_ptr<Project>> projects_;
  std::map<std::string, std::string> roots_;  ///< by path
  std::set<std::string> published_;
  std::optional<std::int64_t> editor_;
  std::optional<Refusal> refusal_;  ///< of the present request
  bool changed_ = false;
  bool initialized_ = false;
  bool shutDown_ = false;
  bool ended_ = false;
};

}  // namespace xabsl::server
