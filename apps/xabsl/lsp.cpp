#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <iostream>
#include <string>

#include "Commands.h"
#include "xabsl/tools/server/MessageReader.h"
#include "xabsl/tools/server/Server.h"

namespace xabsl::app {

namespace {

/// True if no input comes for so many milliseconds.
bool idle(int ms) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, ms) == 0;
}

/// Whether the editor has ended without a word, while another process holds our input.
bool isAlone(const server::Server& server) {
  const auto editor = server.editor();
  return editor && kill(static_cast<pid_t>(*editor), 0) != 0 && errno == ESRCH;
}

/// Serves an editor on the standard input and output until the session ends. Returns the exit
/// status.
int serve() {
  server::MessageReader reader;
  server::Server server({diskReader(), diskLister()}, [](const std::string& message) {
    std::cout << "Content-Length: " << message.size() << "\r\n\r\n" << message << std::flush;
  });
  constexpr int watched = 2000;  // ms between two looks at the editor
  std::array<char, 65536> bytes;
  while (!server.ended() && !reader.broken()) {
    if (idle(watched)) {
      if (isAlone(server)) break;
      continue;
    }
    const ssize_t count = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count <= 0) break;
    reader.add({bytes.data(), static_cast<std::size_t>(count)});
    while (const auto message = reader.next()) {
      server.handle(*message);
      if (server.ended()) break;
    }
    if (idle(0)) server.publish();
  }
  if (reader.broken()) {
    printError("xabsl lsp", "the input is no message of the language server protocol");
    return wrong;
  }
  return server.status();
}

}  // namespace

void addLsp(CLI::App& program, int& status) {
  program
      .add_subcommand("lsp", "Serve an editor by the language server protocol, on stdin and stdout")
      ->callback([&status] { status = serve(); });
}

}  // namespace xabsl::app
