#include "network/SubnetSearch.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>

namespace gt {
namespace {

/// All addresses are tried again after so long, in ms.
constexpr std::int64_t searchPeriod = 5000;
/// Who has not answered after so long is not there, in ms.
constexpr std::int64_t patience = 2000;

bool isConnected(const FileDescriptor& socket) {
  int error = 0;
  socklen_t size = sizeof error;
  return getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0;
}

}  // namespace

void SubnetSearch::begin() {
  for (int number = 1; number < 255; ++number) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port_));
    const std::string text = subnet_ + "." + std::to_string(number);
    if (found_[static_cast<std::size_t>(number)] ||
        inet_pton(AF_INET, text.c_str(), &address.sin_addr) != 1)
      continue;
    FileDescriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
    if (!socket) return;  // as many as the system allows; the others next time
    // Its outcome, even if it is there at once, is what poll() returns.
    (void)!connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
    attempts_.push_back({number, std::move(socket)});
  }
}

std::vector<int> SubnetSearch::find(std::int64_t now) {
  if (begun_ < 0 || now - begun_ >= searchPeriod) {
    attempts_.clear();
    begin();
    begun_ = now;
  }
  std::vector<pollfd> polled;
  for (const Attempt& attempt : attempts_) polled.push_back({attempt.socket.number(), POLLOUT, 0});
  std::vector<int> numbers;
  if (polled.empty() || poll(polled.data(), polled.size(), 0) < 0) return numbers;
  std::vector<Attempt> open;
  for (std::size_t i = 0; i < attempts_.size(); ++i) {
    if (polled[i].revents == 0) {
      open.push_back(std::move(attempts_[i]));
    } else if (isConnected(attempts_[i].socket)) {
      numbers.push_back(attempts_[i].number);
      found_[static_cast<std::size_t>(attempts_[i].number)] = true;
    }
  }
  attempts_ = std::move(open);
  if (now - begun_ >= patience) attempts_.clear();
  return numbers;
}

}  // namespace gt
