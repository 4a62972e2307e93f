#include "network/RobotList.h"

#include <algorithm>
#include <filesystem>

#include "base/Number.h"
#include "network/LocalSocket.h"

namespace gt {
namespace {

constexpr std::size_t robotsPerTeam = 4;
constexpr std::size_t mostRobots = 32;
/// The tools' ports of robots without a number of their own, above the router's port.
constexpr int firstPortWithoutNumber = 301;
/// How often it looks who is on this machine, in ms.
constexpr std::int64_t period = 1000;
/// Where the Debug process of a robot listens for tools (RobotAddresses.h).
constexpr std::string_view toolsEnding = ".Tools";

std::optional<int> numberIn(std::string_view text, int low, int high) {
  const auto number = numberFrom<int>(text);
  return number && *number >= low && *number <= high ? number : std::nullopt;
}

/// The parts of an address of numbers between dots; empty if it is none.
std::vector<int> numbersOf(const std::string& text) {
  std::vector<int> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t dot = std::min(text.find('.', at), text.size());
    const auto number = numberIn(std::string_view{text}.substr(at, dot - at), 0, 255);
    if (!number) return {};
    numbers.push_back(*number);
    at = dot + 1;
  }
  return numbers;
}

/// Of a robot that was found: 10.0.1.10 to 10.0.1.13 are a team, as are red1 to red4.
std::string teamOf(const std::string& name) {
  const bool numbered = !name.empty() && name.back() >= '0' && name.back() <= '9';
  return name.substr(0, name.size() - (numbered ? 1 : 0));
}

}  // namespace

Result<RobotList> RobotList::parse(const std::vector<std::string>& words, const Places& places) {
  RobotList list{places};
  std::string subnet;
  for (const std::string& word : words)
    if (auto done = list.take(word, subnet); !done) return done.error();
  return list;
}

Result<void> RobotList::take(const std::string& word, std::string& subnet) {
  const auto equals = word.find('=');
  const std::vector<int> numbers = numbersOf(word);
  if (equals != word.npos && equals > 0 && equals + 1 < word.size())
    return add(word.substr(0, equals), word.substr(equals + 1), {}, nextTeam());
  if (numbers.size() == 4) return addAddress(word, numbers.back(), nextTeam());
  if (numbers.size() == 3) {
    subnet = word;
  } else if (numbers.size() == 1 && !subnet.empty()) {
    return addAddress(subnet + "." + word, numbers[0], nextTeam());
  } else if (word == "auto" && subnet.empty()) {
    here_ = true;
  } else if (word == "auto") {
    const auto sameSubnet = [&](const SubnetSearch& s) { return s.subnet() == subnet; };
    if (std::ranges::none_of(subnets_, sameSubnet)) subnets_.emplace_back(subnet, places_.port);
  } else {
    return Error{.field = word,
                 .what =
                     "is no robot: expected NAME=ENDPOINT, an address as 10.0.1.100, a subnet and "
                     "numbers as 10.0.1 100 101, or auto"};
  }
  return {};
}

std::string RobotList::nextTeam() const {
  return {static_cast<char>('A' + robots_.size() / robotsPerTeam)};
}

Result<void> RobotList::addAddress(const std::string& address, int number,
                                   const std::string& team) {
  return add(address, "tcp://" + address + ":" + std::to_string(places_.port), number, team);
}

Result<void> RobotList::add(const std::string& name, const std::string& endpoint,
                            std::optional<int> number, const std::string& team) {
  const int port = places_.port + (number ? *number : firstPortWithoutNumber + withoutNumber_);
  const std::string tools = "tcp://" + places_.listen + ":" + std::to_string(port);
  if (robots_.size() >= mostRobots)
    return Error{.field = name, .what = "is one too many: a router serves up to 32 robots"};
  for (const RoutedRobot& other : robots_)
    if (other.tools == tools || other.name == name || other.robot == endpoint)
      return Error{.field = name, .what = "has the name or number of another robot"};
  robots_.push_back({name, endpoint, tools, team});
  withoutNumber_ += !number;
  return {};
}

std::size_t RobotList::find(std::int64_t now) {
  const std::size_t before = robots_.size();
  // Whoever is known already, or is one too many, is passed over.
  for (SubnetSearch& search : subnets_)
    for (const int number : search.find(now)) {
      const std::string address = search.subnet() + "." + std::to_string(number);
      (void)!addAddress(address, number, teamOf(address));
    }
  if (here_ && (looked_ < 0 || now - looked_ >= period)) {
    findHere();
    looked_ = now;
  }
  return robots_.size() - before;
}

void RobotList::findHere() {
  std::vector<std::string> names;
  std::error_code failed;  // as long as there is no folder, there is no robot
  for (const auto& entry : std::filesystem::directory_iterator{places_.sockets, failed}) {
    const std::string file = entry.path().filename().string();
    if (file.size() <= toolsEnding.size() || !file.ends_with(toolsEnding)) continue;
    const std::string name = file.substr(0, file.size() - toolsEnding.size());
    const bool known = std::ranges::any_of(robots_, [&](const auto& r) { return r.name == name; });
    if (!known && somebodyListens(entry.path().string())) names.push_back(name);
  }
  std::ranges::sort(names);
  for (const std::string& name : names) {
    const std::string endpoint = "ipc://" + places_.sockets + "/" + name;
    (void)!add(name, endpoint + std::string{toolsEnding}, {}, teamOf(name));
  }
}

}  // namespace gt
