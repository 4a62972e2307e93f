#include "base/ConnectedProgram.h"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

namespace gt {

Result<ConnectedProgram> ConnectedProgram::start(const std::vector<std::string>& command) {
  const auto failed = [&](int number) {
    return Error{.file = command.front(),
                 .what = std::string{"cannot be started: "} + std::strerror(number)};
  };
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return failed(errno);
  FileDescriptor own{ends[0]}, others{ends[1]};
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, others.number(), 0);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  pid_t id = -1;
  const int failure =
      posix_spawn(&id, arguments.front(), &actions, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (failure != 0) return failed(failure);
  return ConnectedProgram{id, std::move(own)};
}

ConnectedProgram::ConnectedProgram(ConnectedProgram&& other) noexcept
    : id_{std::exchange(other.id_, -1)},
      status_{other.status_},
      socket_{std::move(other.socket_)} {}

ConnectedProgram::~ConnectedProgram() {
  socket_ = {};
  if (waitForEnd()) return;
  kill(id_, SIGKILL);
  waitpid(id_, &status_, 0);
}

bool ConnectedProgram::waitForEnd() {
  constexpr std::chrono::seconds patience{2};
  const auto begin = std::chrono::steady_clock::now();
  while (id_ > 0) {
    if (waitpid(id_, &status_, WNOHANG) != 0)
      id_ = -1;
    else if (std::chrono::steady_clock::now() - begin > patience)
      return false;
    else
      std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  return true;
}

std::string ConnectedProgram::ending() {
  if (!waitForEnd()) return "runs still";
  if (WIFSIGNALED(status_)) return "was ended by signal " + std::to_string(WTERMSIG(status_));
  return "has ended with status " + std::to_string(WEXITSTATUS(status_));
}

}  // namespace gt
