#pragma once
#include <memory>
#include <string>
#include <vector>

#include "foxglove/FoxgloveServer.h"
#include "network/Router.h"
#include "network/RouterSettings.h"
#include "network/Vocabulary.h"
#include "observer/ObservedRobot.h"

namespace gt {

/// Shows the robots of a router to Foxglove and Lichtblick.
class Viewers {
 public:
  /// Where the settings let in only tools with keys, it uses the key for connecting.
  static Result<std::unique_ptr<Viewers>> open(Router& router, const RouterSettings& settings,
                                               const RouterOptions& options);

  /// Passes on what robots have sent, also those that were found meanwhile.
  Result<void> update();
  const FoxgloveServer& server() const { return *server_; }
  /// Who was not let in: lines for the user that were not taken yet.
  std::vector<std::string> takeNews() { return server_->takeNews(); }

 private:
  Viewers(Router& router, std::unique_ptr<FoxgloveServer> server);

  Router& router_;
  std::optional<Keys> keys_;
  Vocabulary vocabulary_;
  Network network_;
  std::vector<std::unique_ptr<ObservedRobot>> robots_;
  std::unique_ptr<FoxgloveServer> server_;
};

}  // namespace gt
