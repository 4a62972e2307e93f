#include "base/ChildProgram.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

namespace gt {

ChildProgram::ChildProgram(std::vector<std::string> command) : command_{std::move(command)} {
  start();
}

void ChildProgram::start() {
  // Made before the fork: after it, memory may be locked by a thread that the child does not have.
  std::vector<char*> arguments;
  for (std::string& argument : command_) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ != 0) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  execv(arguments[0], arguments.data());
  _exit(127);
}

bool ChildProgram::runs() {
  if (pid_ > 0 && waitpid(pid_, &status_, WNOHANG) != 0) pid_ = -1;
  return pid_ > 0;
}

void ChildProgram::kill(int signal) {
  if (pid_ <= 0) return;
  ::kill(pid_, signal);
  waitpid(pid_, &status_, 0);
  pid_ = -1;
}

double ChildProgram::memory() const {
  std::ifstream file{"/proc/" + std::to_string(pid_) + "/statm"};
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

}  // namespace gt
