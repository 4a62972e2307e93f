#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/FileDescriptor.h"

namespace gt {

/// Looks again and again at which of the 254 addresses of a subnet somebody listens on a port, by
/// connecting to each and leaving at once. Never waits.
class SubnetSearch {
 public:
  /// `subnet` is the first three numbers of the addresses, as 10.0.1.
  SubnetSearch(std::string subnet, int port) : subnet_{std::move(subnet)}, port_{port} {}

  const std::string& subnet() const { return subnet_; }
  /// The last numbers of the addresses that were found since this was asked last, ascending. To be
  /// called often; `now` in ms.
  std::vector<int> find(std::int64_t now);

 private:
  struct Attempt {
    int number;
    FileDescriptor socket;
  };

  void begin();

  std::string subnet_;
  int port_;
  std::array<bool, 256> found_{};
  std::vector<Attempt> attempts_;
  std::int64_t begun_ = -1;
};

}  // namespace gt
