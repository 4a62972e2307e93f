#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "framework/Process.h"
#include "network/Wire.h"

namespace gt::testing {

/// A folder for sockets and files of one test, with a name that nobody else has.
class TestFolder {
 public:
  TestFolder() {
    std::string path = (std::filesystem::temp_directory_path() / "gt2003-XXXXXX").string();
    path_ = mkdtemp(path.data()) ? path : "";
  }
  ~TestFolder() { std::filesystem::remove_all(path_); }
  std::string file(const std::string& name) const { return path_ + "/" + name; }
  std::string endpoint(const std::string& name) const { return "ipc://" + file(name); }

 private:
  std::string path_;
};

struct NumberPackage {
  int number = 0;

  static constexpr auto fields() { return std::tuple{field("number", &NumberPackage::number)}; }
};

/// A process whose main() is given by the test.
struct Custom : Process {
  explicit Custom(const std::string& name) : Process{name} {}
  int main() override {
    if (work) work();
    return pause;
  }
  std::function<void()> work;
  int pause = -1;
};

/// Lets something happen again and again until a condition holds; false if it does not in time.
template <typename Condition, typename Action>
bool eventually(Condition condition, Action action, int ms = 5000) {
  for (int i = 0; i < ms; ++i) {
    if (condition()) return true;
    action();
    usleep(1000);
  }
  return false;
}

}  // namespace gt::testing
