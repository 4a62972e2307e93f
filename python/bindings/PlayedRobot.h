#pragma once
#include <nanobind/nanobind.h>

#include <map>
#include <string>
#include <vector>

#include "PlayedMatch.h"
#include "streams/Type.h"

namespace gt::python {

/// A robot of a match that Python plays; keeps the match alive.
class PlayedRobot {
 public:
  PlayedRobot(nanobind::object match, std::size_t index)
      : owner_{std::move(match)}, match_{&nanobind::cast<PlayedMatch&>(owner_)}, index_{index} {}

  const nanobind::object& owner() const { return owner_; }
  std::string name() const { return robot().name(); }
  nanobind::object get(const std::string& path) const;
  void set(const std::string& path, nanobind::handle value) const;
  std::vector<std::string> representations() const;
  std::map<std::string, std::string> solutions() const;
  nanobind::object solve(const std::string& task, nanobind::handle solution) const;
  nanobind::dict parameters(const std::string& task, const std::string& solution) const;
  nanobind::object image() const;
  nanobind::object labels() const;
  nanobind::object truePose() const;
  nanobind::dict times() const;

 private:
  SimulatedRobot& robot() const { return *match_->match().robots()[index_]; }
  std::size_t inSimulation() const { return match_->match().robotIndex(index_); }
  ModuleProcess& solving(const std::string& task) const;
  /// Stores the path as it is spelled in C++ in `spelled`.
  ConstValue valueAt(const std::string& path, std::string* spelled = nullptr) const;
  ConstValue parameterAt(const std::string& path) const;
  /// Executes a line of the console for this robot; an error is about what was given.
  void execute(const std::string& line, const std::string& about) const;
  void setFields(const std::string& path, nanobind::handle value, const Type& type) const;

  nanobind::object owner_;
  PlayedMatch* match_;
  std::size_t index_;
};

}  // namespace gt::python
