#include "robot/Graphviz.h"

#include <fcntl.h>
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
  const std::string source = file + ".dot", errors = file + ".errors";
  if (auto done = writeFile(source, drawing); !done) return done;
  std::string command[] = {"dot", "-Tsvg", "-o" + file, source};
  char* arguments[] = {command[0].data(), command[1].data(), command[2].data(), command[3].data(),
                       nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(),
                                   O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t child = 0;
  const bool started = posix_spawnp(&child, "dot", &actions, nullptr, arguments, environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (started && waitpid(child, &status, 0) < 0) status = -1;
  const auto said = readFile(errors);
  unlink(source.c_str());
  unlink(errors.c_str());
  if (!started) return Error{file, 0, "", "cannot be drawn: Graphviz's program dot is missing"};
  if (status == 0) return {};
  unlink(file.c_str());
  return Error{file, 0, "",
               "cannot be drawn: " + (said ? said->substr(0, said->find('\n')) : "dot failed")};
}

}  // namespace gt
