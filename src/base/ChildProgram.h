#pragma once
#include <sys/types.h>

#include <csignal>
#include <string>
#include <vector>

namespace gt {

/// A child process that is killed when this program ends, however this program ends.
class ChildProgram {
 public:
  /// Starts a program: the path of its file, then its arguments.
  explicit ChildProgram(std::vector<std::string> command);
  ~ChildProgram() { kill(); }
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  /// Starts the program again after it has ended.
  void start();
  bool runs();
  /// Sends the program a signal that ends it, and waits until it has ended.
  void kill(int signal = SIGKILL);
  /// Process id; negative once the program has ended.
  pid_t id() const { return pid_; }
  /// Exit status as waitpid() returns it.
  int status() const { return status_; }
  /// Resident memory of the program, in MB.
  double memory() const;

 private:
  std::vector<std::string> command_;
  pid_t pid_ = -1;
  int status_ = 0;
};

}  // namespace gt
