#pragma once
#include <string>

#include "base/Result.h"
#include "streams/Reflection.h"

namespace gt {

/// Keys for connections with other machines (ZeroMQ CURVE): a listener only accepts clients that
/// own the client's secret key, and authenticates itself by its own key. Read from a key file.
struct Keys {
  std::string serverPublic;
  std::string serverSecret;
  std::string clientPublic;
  std::string clientSecret;

  static constexpr auto fields() {
    return Fields{field<&Keys::serverPublic>("public key of the listener"),
                  field<&Keys::serverSecret>("secret key of the listener, required to listen"),
                  field<&Keys::clientPublic>("public key of the client"),
                  field<&Keys::clientSecret>("secret key of the client, required to connect")};
  }
  bool canListen() const { return !serverSecret.empty() && !clientPublic.empty(); }
  bool canConnect() const { return !clientSecret.empty() && !serverPublic.empty(); }
};

/// Writes a new pair of files into a folder, readable by the user only: `robot.key` for listeners
/// (robots, router), `tool.key` for clients. Existing files are not replaced.
Result<void> makeKeys(const std::string& folder);
/// Reads a key file. Returns an error if a key is invalid.
Result<Keys> loadKeys(const std::string& file);

}  // namespace gt
