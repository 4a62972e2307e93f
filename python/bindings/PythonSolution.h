#pragma once
#include <nanobind/nanobind.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "base/Time.h"
#include "framework/SolutionTable.h"

namespace gt::python {

/// What solutions written in Python did wrong. Robots of several threads note it.
class SolutionFailures {
 public:
  struct Failure {
    std::size_t robot;
    Time time;
    std::string task, solution, trace;
  };

  void note(Failure failure);
  /// All so far, in the order of time, then of the robots.
  std::vector<Failure> all() const;

 private:
  mutable std::mutex mutex_;
  std::vector<Failure> failures_;
};

/// A solution of a task for one robot that is written in Python: an object with a method `update`,
/// whose annotations are its ports. All modules that are made of it share the object.
class PythonSolution {
 public:
  /// `instead` takes over if it fails. Throws a Failure if `update` does not fit the task.
  PythonSolution(const Task& task, const nanobind::object& object, std::size_t robot,
                 std::string instead, std::shared_ptr<SolutionFailures> failures);

  const std::string& name() const;
  const std::string& instead() const;
  /// As the solution table knows it.
  Solution entry() const;
  /// For Python's garbage collector: visits what it holds, and lets it go, after which it fails.
  int traverse(visitproc visit, void* arg) const;
  void clear();

 private:
  class Module;
  struct Content;

  std::shared_ptr<Content> content_;
};

}  // namespace gt::python
