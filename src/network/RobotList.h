#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/Result.h"
#include "network/Router.h"
#include "network/SubnetSearch.h"

namespace gt {

/// The robots that a router serves, as given by the words of its command line (report 5.3):
/// `10.0.1.100`, or `10.0.1 100 101 102` for several robots of a subnet, or `NAME=ENDPOINT`. The
/// router searches for further robots in a subnet for `10.0.1 auto`, and on this machine for
/// `auto`.
class RobotList {
 public:
  /// Addresses on which robots and the router listen.
  struct Places {
    std::string listen = "127.0.0.1";  ///< Address of the router.
    int port = 15000;                  ///< Port of robots that are given by address; see toolsOf().
    std::string sockets;               ///< Folder of the sockets of this machine's robots.
  };

  static Result<RobotList> parse(const std::vector<std::string>& words, const Places& places);

  /// The robots that were given or found. The first four given robots are team A, the next ones
  /// team B. Found robots are teammates if their names (or addresses) differ in the last digit
  /// only.
  const std::vector<RoutedRobot>& robots() const { return robots_; }
  /// Whether robots are searched for.
  bool searches() const { return here_ || !subnets_.empty(); }
  /// Appends the robots found since the last call and returns their number. Must be called often;
  /// does not block; `now` in ms.
  std::size_t find(std::int64_t now);

 private:
  explicit RobotList(const Places& places) : places_{places} {}
  Result<void> take(const std::string& word, std::string& subnet);
  Result<void> add(const std::string& name, const std::string& endpoint, std::optional<int> number,
                   const std::string& team);
  Result<void> addAddress(const std::string& address, int number, const std::string& team);
  std::string nextTeam() const;
  void findHere();

  Places places_;
  std::vector<RoutedRobot> robots_;
  std::vector<SubnetSearch> subnets_;
  bool here_ = false;
  int withoutNumber_ = 0;
  std::int64_t looked_ = -1;
};

}  // namespace gt
