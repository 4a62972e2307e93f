#include "base/Program.h"

#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "base/FileDescriptor.h"

namespace gt {
namespace {

/// A file without a name. It may have any size, so that neither side waits for the other one.
FileDescriptor memoryFile(std::string_view content = {}) {
  FileDescriptor file{memfd_create("program", MFD_CLOEXEC)};
  while (!content.empty()) {
    const ssize_t n = write(file.number(), content.data(), content.size());
    if (n <= 0) return FileDescriptor{};
    content.remove_prefix(static_cast<std::size_t>(n));
  }
  lseek(file.number(), 0, SEEK_SET);
  return file;
}

std::string contentOf(const FileDescriptor& file) {
  std::string content;
  std::array<char, 4096> buffer;
  lseek(file.number(), 0, SEEK_SET);
  for (ssize_t n = 0; (n = read(file.number(), buffer.data(), buffer.size())) > 0;)
    content.append(buffer.data(), static_cast<std::size_t>(n));
  return content;
}

}  // namespace

Result<ProgramResult> runProgram(const std::vector<std::string>& command, std::string_view input) {
  const auto failed = [&](int number) {
    return Error{.file = command.front(),
                 .what = std::string("cannot be run, is it installed? ") + std::strerror(number)};
  };
  const std::array files{memoryFile(input), memoryFile(), memoryFile()};
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  for (int i = 0; i < 3; ++i) {
    const FileDescriptor& file = files[static_cast<std::size_t>(i)];
    if (!file) return failed(errno);
    posix_spawn_file_actions_adddup2(&actions, file.number(), i);
  }
  pid_t child = 0;
  const int failure =
      posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return failed(failure);
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return failed(errno);
  return ProgramResult{WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
                       contentOf(files[1]), contentOf(files[2])};
}

}  // namespace gt
