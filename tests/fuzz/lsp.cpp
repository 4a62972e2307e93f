#include <algorithm>
#include <string>
#include <vector>

#include "Fuzz.h"
#include "xabsl/language/VirtualFiles.h"
#include "xabsl/tools/server/MessageReader.h"
#include "xabsl/tools/server/Server.h"

/// The first byte chooses: a stream of messages as it is, or the text of a file that an editor has
/// open, about which everything is asked at a place in it. A line `=== path` begins another file,
/// which lies on the disk; the last one is open.
namespace {

using namespace xabsl::server;

Server makeServer(const xabsl::VirtualFiles& files) {
  return Server({xabsl::readerOf(files),
                 [&files](const std::string&) {
                   std::vector<std::string> paths;
                   for (const auto& [path, text] : files) paths.push_back(path);
                   return paths;
                 }},
                [](const std::string&) {});
}

/// The files of a text, and the path of the last one.
std::string take(std::string_view text, xabsl::VirtualFiles& files) {
  std::string path = "/a.xabsl";
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (line.starts_with("=== ") && line.find_first_of("\"\\") == line.npos)
      path = "/" + std::string{line.substr(4)};
    else
      files[path].append(line).append("\n");
    begin = end + 1;
  }
  return path;
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
  xabsl::VirtualFiles files;
  const std::string path = take(text, files);
  const std::string document = R"("textDocument":{"uri":"file://)" + path + '"';
  Server server = makeServer(files);
  server.handle(R"({"id":1,"method":"initialize","params":{}})");
  server.handle(R"({"method":"textDocument/didOpen","params":{)" + document + R"(,"text":)" +
                quoted(std::string_view{files[path]}) + "}}}");
  server.publish();
  for (const std::string_view method :
       {"completion", "definition", "references", "documentHighlight", "hover", "prepareRename",
        "rename", "documentSymbol", "foldingRange", "semanticTokens/full", "formatting"})
    server.handle(
        R"({"id":2,"method":"textDocument/)" + std::string(method) + R"(","params":{)" + document +
        R"(},"newName":"other","context":{"includeDeclaration":true},"position":{"line":)" +
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
  const xabsl::VirtualFiles none;
  Server server = makeServer(none);
  MessageReader reader;
  reader.add(rest);
  while (const auto message = reader.next()) {
    server.handle(*message);
    server.publish();
  }
  return 0;
}
