#include "robot/Graphviz.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "streams/File.h"

extern char** environ;

namespace gt {

std::string dotQuoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

Result<void> writeSvg(const std::string& drawing, const std::string& file) {
  const std::string source = file + ".dot";
  if (auto done = writeFile(source, drawing); !done) return done;
  std::string command[] = {"dot", "-Tsvg", "-o" + file, source};
  char* arguments[] = {command[0].data(), command[1].data(), command[2].data(), command[3].data(),
                       nullptr};
  pid_t child = 0;
  int status = posix_spawnp(&child, "dot", nullptr, nullptr, arguments, environ);
  if (status == 0 && waitpid(child, &status, 0) < 0) status = -1;
  unlink(source.c_str());
  if (status != 0)
    return Error{file, 0, "", "cannot be drawn: Graphviz's program dot is missing or failed"};
  return {};
}

}  // namespace gt
