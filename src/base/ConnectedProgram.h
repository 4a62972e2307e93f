#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

#include "base/FileDescriptor.h"
#include "base/Result.h"

namespace gt {

/// Another program that this one starts. Both communicate over a socket, which is the other
/// program's standard input. The program must end when the socket is closed. It runs in a process
/// group of its own, so a Ctrl-C in the terminal does not reach it.
class ConnectedProgram {
 public:
  /// Starts a program: its path, then its arguments. Returns an error if it cannot be started.
  static Result<ConnectedProgram> start(const std::vector<std::string>& command);
  ConnectedProgram(ConnectedProgram&& other) noexcept;
  ConnectedProgram& operator=(ConnectedProgram&&) = delete;
  /// Closes the socket and kills the program if it has not ended by itself after two seconds.
  ~ConnectedProgram();

  /// Returns this program's end of the socket. It can be taken once.
  FileDescriptor takeSocket() { return std::move(socket_); }
  /// Describes for messages how the program ended, or that it is still running. If it is running,
  /// waits up to two seconds for its end.
  std::string ending();
  /// Process id; negative once the program has ended.
  pid_t id() const { return id_; }

 private:
  ConnectedProgram(pid_t id, FileDescriptor socket) : id_{id}, socket_{std::move(socket)} {}
  bool waitForEnd();

  pid_t id_;
  int status_ = 0;
  FileDescriptor socket_;
};

}  // namespace gt
