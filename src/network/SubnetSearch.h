#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/FileDescriptor.h"

namespace gt {

/// Repeatedly searches the 254 addresses of a subnet for programs that listen on a port, by
/// connecting to each address and disconnecting immediately. Does not block.
class SubnetSearch {
 public:
  /// `subnet` consists of the first three numbers of the addresses, such as 10.0.1.
  SubnetSearch(std::string subnet, int port) : subnet_{std::move(subnet)}, port_{port} {}

  const std::string& subnet() const { return subnet_; }
  /// The last numbers of the addresses found since the last call, in ascending order. Must be
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
