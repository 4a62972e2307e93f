#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

#include "base/FileDescriptor.h"
#include "base/Result.h"

namespace gt {

/// Another program, which this one starts and talks with over a socket that is its standard input.
/// It shall end when the socket is closed. It is in a process group of its own, so a Ctrl-C in the
/// terminal is not for it.
class ConnectedProgram {
 public:
  /// Starts a program: its path, then its arguments. An error if it cannot be started.
  static Result<ConnectedProgram> start(const std::vector<std::string>& command);
  ConnectedProgram(ConnectedProgram&& other) noexcept;
  ConnectedProgram& operator=(ConnectedProgram&&) = delete;
  /// Kills it, if it has not ended by itself shortly after its socket was closed.
  ~ConnectedProgram();

  /// This program's end of the socket, which can be taken once.
  FileDescriptor takeSocket() { return std::move(socket_); }
  /// How it has ended, or that it runs still, for messages. Waits for a moment if it runs.
  std::string ending();
  /// Its process id; negative once it has ended.
  pid_t id() const { return id_; }

 private:
  ConnectedProgram(pid_t id, FileDescriptor socket) : id_{id}, socket_{std::move(socket)} {}
  bool waitForEnd();

  pid_t id_;
  int status_ = 0;
  FileDescriptor socket_;
};

}  // namespace gt
