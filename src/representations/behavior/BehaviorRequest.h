#pragma once
#include <string>
#include <vector>

#include "streams/Reflection.h"

namespace gt {

/// Asks a robot to go on with another behavior, or with its own after it was edited. If that has an
/// error, or asks for what the robot does not offer, the one that runs goes on. Sent by tools.
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
        field<&BehaviorRequest::path>("the file with the agents"),
        field<&BehaviorRequest::files>(
            "that one and all that it includes; none: the robot reads them from its disk")};
  }
};

}  // namespace gt
