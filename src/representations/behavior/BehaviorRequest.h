#pragma once
#include <string>
#include <vector>

#include "streams/Reflection.h"

namespace gt {

/// Switches a robot to another behavior, or reloads its own after it was edited. If the new
/// behavior has an error or uses symbols that the robot does not offer, the present behavior
/// continues. Sent by tools.
struct BehaviorRequest {
  struct File {
    std::string path;
    std::string text;

    static constexpr auto fields() { return Fields{field<&File::path>(), field<&File::text>()}; }
  };

  std::string path;
  std::vector<File> files;

  static constexpr auto fields() {
    return Fields{
        field<&BehaviorRequest::path>("path of the file with the agents"),
        field<&BehaviorRequest::files>(
            "the agents file and all files that it includes; empty: the robot reads them from its "
            "disk")};
  }
};

}  // namespace gt
