#pragma once
#include <string>

#include "streams/Reflection.h"

namespace gt {

/// Asks a robot to go on with another behavior, or with its own after it was edited. If that has an
/// error, or asks for what the robot does not offer, the one that runs goes on.
struct BehaviorRequest {
  std::string path;
  std::string text;

  static constexpr auto fields() {
    return std::tuple{
        field("path", &BehaviorRequest::path, "", "the file with the agents"),
        field("text", &BehaviorRequest::text, "", "the whole behavior; empty: read the files")};
  }
};
static_assert(complete<BehaviorRequest>);

}  // namespace gt
