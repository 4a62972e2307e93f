#include <optional>
#include <string>
#include <vector>

#include "Fuzz.h"
#include "xabsl/tools/server/MessageReader.h"
#include "xabsl/tools/server/Server.h"

/// The first byte chooses: a stream of messages as it is, or the text of a file that an editor has
/// open, about which everything is asked at a place in it.
namespace {

using namespace xabsl::server;

Server makeServer() {
  return Server(
      {[](const std::string&, std::string&) { return std::optional<std::string>("no disk"); },
       [](const std::string&) { return std::vector<std::string>(); }},
      [](const std::string&) {});
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < ' ' && c != '\n' ? ' ' : c;
    if (c == '\n') result.replace(result.size() - 1, 1, "\\n");
  }
  return result + '"';
}

void askAll(std::string_view text, unsigned line, unsigned character) {
  Server server = makeServer();
  server.handle(R"({"id":1,"method":"initialize","params":{}})");
  server.handle(
      R"({"method":"textDocument/didOpen","params":{"textDocument":{"uri":"file:///a.xabsl","text":)" +
      quoted(text) + "}}}");
  server.publish();
  for (const std::string_view method :
       {"completion", "definition", "references", "documentHighlight", "hover", "prepareRename",
        "rename", "documentSymbol", "foldingRange", "semanticTokens/full", "formatting"})
    server.handle(
        R"({"id":2,"method":"textDocument/)" + std::string(method) +
        R"(","params":{"textDocument":{"uri":"file:///a.xabsl"},"newName":"other","context":{"includeDeclaration":true},"position":{"line":)" +
        std::to_string(line) + R"(,"character":)" + std::to_string(character) + "}}}");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 3) return 0;
  const std::string_view rest = gt::textOf(data + 3, size - 3);
  if (data[0] % 4 != 0) {
    askAll(rest, data[1], data[2]);
    return 0;
  }
  Server server = makeServer();
  MessageReader reader;
  reader.add(rest);
  while (const auto message = reader.next()) {
    server.handle(*message);
    server.publish();
  }
  return 0;
}
