#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/Result.h"
#include "network/Router.h"
#include "network/SubnetSearch.h"

namespace gt {

/// The robots that a router serves, by the words of its command line (report 5.3): `10.0.1.100`, or
/// `10.0.1 100 101 102` for several of a subnet, or `NAME=ENDPOINT`; and those that it finds by
/// itself, by `10.0.1 auto` in a subnet, by `auto` alone on this machine.
class RobotList {
 public:
  /// Where robots and the router listen.
  struct Places {
    std::string listen = "127.0.0.1";  ///< Address of the router.
    int port = 15000;                  ///< Of robots with an address; see toolsOf().
    std::string sockets;               ///< Folder of the sockets of this machine's robots.
  };

  static Result<RobotList> parse(const std::vector<std::string>& words, const Places& places);

  /// Those that have been named or found. The first four named are the team A, the next the team B;
  /// of those found, whose names (or addresses) differ in the last digit only are teammates.
  const std::vector<RoutedRobot>& robots() const { return robots_; }
  /// Whether robots are searched for.
  bool searches() const { return here_ || !subnets_.empty(); }
  /// Appends the robots that were found since this was called last; returns how many. To be called
  /// often, never waits; `now` in ms.
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
