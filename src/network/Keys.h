#pragma once
#include <string>

#include "base/Result.h"
#include "streams/Reflection.h"

namespace gt {

/// Who may connect to whom beyond this machine (ZeroMQ CURVE): a listener lets in only who holds
/// the client's secret key, and proves itself by its own. Read from a key file.
struct Keys {
  std::string serverPublic;
  std::string serverSecret;
  std::string clientPublic;
  std::string clientSecret;

  static constexpr auto fields() {
    return Fields{field<&Keys::serverPublic>("of who listens"),
                  field<&Keys::serverSecret>("needed to listen"),
                  field<&Keys::clientPublic>("of who connects"),
                  field<&Keys::clientSecret>("needed to connect")};
  }
  bool canListen() const { return !serverSecret.empty() && !clientPublic.empty(); }
  bool canConnect() const { return !clientSecret.empty() && !serverPublic.empty(); }
};

/// Writes a new pair of files into a folder, readable for the user alone: `robot.key` for who
/// listens (robots, router), `tool.key` for who connects. Files that exist are not replaced.
Result<void> makeKeys(const std::string& folder);
/// Reads a key file; an error if a key is no key.
Result<Keys> loadKeys(const std::string& file);

}  // namespace gt
