#pragma once
#include <sys/types.h>

#include <csignal>
#include <string>
#include <vector>

namespace gt {

/// Another program that this one starts, and that ends with it, however this one ends.
class ChildProgram {
 public:
  /// Starts a program: its file, then its arguments.
  explicit ChildProgram(std::vector<std::string> command);
  ~ChildProgram() { kill(); }
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  /// Starts it again after its end.
  void start();
  bool runs();
  /// Sends it a signal by which it ends, and waits until it has.
  void kill(int signal = SIGKILL);
  /// Its process id; negative once it has ended.
  pid_t id() const { return pid_; }
  /// How it ended, as waitpid() returns it.
  int status() const { return status_; }
  /// What it has of the memory, in MB.
  double memory() const;

 private:
  std::vector<std::string> command_;
  pid_t pid_ = -1;
  int status_ = 0;
};

}  // namespace gt
