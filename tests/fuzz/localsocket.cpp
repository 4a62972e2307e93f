#include "network/LocalSocket.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <vector>

#include "Fuzz.h"
#include "base/TemporaryFolder.h"
#include "framework/Representation.h"
#include "framework/RepresentationDefinition.h"
#include "network/Network.h"

namespace {

constexpr gt::SocketLimits limits{8, 300'000, 3};

struct Load {
  std::vector<std::uint8_t> bytes;

  static constexpr auto fields() { return gt::Fields{gt::field<&Load::bytes>()}; }
};

/// The fuzzer's bytes, piece by piece; zeros at their end.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : bytes_{data, size} {}
  bool empty() const { return bytes_.empty(); }
  template <typename T>
  T take() {
    T value{};
    const auto part = takeBytes(sizeof value);
    std::memcpy(&value, part.data(), part.size());
    return value;
  }
  std::span<const std::uint8_t> takeBytes(std::size_t size) {
    const auto part = bytes_.first(std::min(size, bytes_.size()));
    bytes_ = bytes_.subspan(part.size());
    return part;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

gt::FileDescriptor makeSocket() {
  return gt::FileDescriptor{::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
}

sockaddr_un addressOf(const std::string& path) {
  sockaddr_un address{AF_UNIX, {}};
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  return address;
}

/// The other program: sends messages as the fuzzer wants them, and memory, which it writes as it
/// likes.
class Peer {
 public:
  explicit Peer(gt::FileDescriptor socket) : socket_{std::move(socket)} {}
  ~Peer() {
    if (memory_) munmap(memory_, size_);
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  /// Memory of some size, with or without the seals that are expected.
  void makeMemory(std::size_t size, int seals) {
    if (memory_) munmap(memory_, size_);
    memory_ = nullptr;
    file_ = gt::FileDescriptor{memfd_create("fuzz", MFD_CLOEXEC | MFD_ALLOW_SEALING)};
    if (ftruncate(file_.number(), static_cast<off_t>(size)) != 0) return;
    void* place = size == 0
                      ? MAP_FAILED
                      : mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file_.number(), 0);
    fcntl(file_.number(), F_ADD_SEALS, seals);
    if (place == MAP_FAILED) return;
    memory_ = static_cast<std::byte*>(place);
    size_ = size;
  }
  void writeMemory(std::size_t at, std::span<const std::uint8_t> bytes) {
    if (!memory_) return;
    at %= size_;
    std::ranges::copy(std::as_bytes(bytes.first(std::min(bytes.size(), size_ - at))), memory_ + at);
  }
  void send(std::span<const std::uint8_t> bytes, bool withMemory) {
    iovec part{const_cast<std::uint8_t*>(bytes.data()), bytes.size()};
    msghdr message{};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    alignas(cmsghdr) std::array<std::byte, CMSG_SPACE(sizeof(int))> control{};
    if (withMemory && file_) {
      message.msg_control = control.data();
      message.msg_controllen = control.size();
      cmsghdr* beside = CMSG_FIRSTHDR(&message);
      *beside = {CMSG_LEN(sizeof(int)), SOL_SOCKET, SCM_RIGHTS};
      const int number = file_.number();
      std::memcpy(CMSG_DATA(beside), &number, sizeof number);
    }
    (void)!sendmsg(socket_.number(), &message, MSG_DONTWAIT | MSG_NOSIGNAL);
  }
  /// A right notice, of a package that need not be there.
  void notify(std::uint64_t number, std::uint64_t size, bool withMemory) {
    const auto header =
        gt::frameHeader({gt::FrameKind::package, gt::representation<Load>().id, 1, {}, {}});
    std::array<std::uint8_t, 2 * sizeof number + gt::Frame::headerSize> notice;
    std::memcpy(&notice[0], &number, sizeof number);
    std::memcpy(&notice[sizeof number], &size, sizeof size);
    std::memcpy(&notice[2 * sizeof number], header.data(), header.size());
    send(notice, withMemory);
  }

 private:
  gt::FileDescriptor socket_, file_;
  std::byte* memory_ = nullptr;
  std::size_t size_ = 0;
};

/// Reads each frame as a wire would, to its last byte.
void receiveAll(gt::Socket& socket) {
  Load load;
  gt::Received received;
  for (int i = 0; i < 1000 && socket.receive(received); ++i) {
    if (received.frame.bytes.size() > static_cast<std::size_t>(limits.frameSize)) __builtin_trap();
    (void)!gt::representation<Load>().decode(received.frame.bytes, &load);
  }
}

void perform(Input& input, Peer& peer, gt::Socket& socket) {
  const auto action = input.take<std::uint8_t>();
  const bool withMemory = action & 0x80;
  switch (action % 8) {
    case 0:
      peer.send(input.takeBytes(input.take<std::uint16_t>() % 5000), withMemory);
      break;
    case 1: {
      const std::string_view greeting = "GT-local-2 ";
      std::vector<std::uint8_t> bytes{greeting.begin(), greeting.end()};
      const auto name = input.takeBytes(input.take<std::uint8_t>());
      bytes.insert(bytes.end(), name.begin(), name.end());
      peer.send(bytes, withMemory);
      break;
    }
    case 2: {
      const auto size = input.take<std::uint32_t>();
      peer.makeMemory(size % 2'000'000, F_SEAL_SHRINK & input.take<std::uint8_t>());
      break;
    }
    case 3: {
      const auto at = input.take<std::uint32_t>();
      peer.writeMemory(at, input.takeBytes(input.take<std::uint8_t>()));
      break;
    }
    case 4: {
      const auto number = input.take<std::uint64_t>();
      peer.notify(number, input.take<std::uint64_t>(), withMemory);
      break;
    }
    case 5: {
      Load load;
      load.bytes.resize(input.take<std::uint16_t>() * 2U);
      (void)socket.send("peer", gt::FrameKind::package, gt::representation<Load>(), &load);
      break;
    }
    default:
      receiveAll(socket);
  }
}

}  // namespace

/// What another program of this machine writes into a Unix socket and into memory that both see:
/// two that have connected, or one to which this one connects.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gt::TemporaryFolder folder;
  const std::string path = (folder.path() / "socket").string();
  const sockaddr_un address = addressOf(path);
  const auto* raw = reinterpret_cast<const sockaddr*>(&address);
  Input input{data, size};
  gt::Network network;
  gt::Socket* socket = nullptr;
  std::vector<std::unique_ptr<Peer>> peers;
  if (input.take<std::uint8_t>() % 4 > 0) {
    socket = *network.listen("ipc://" + path, {}, limits);
    for (int i = 0; i < 2; ++i) {
      gt::FileDescriptor end = makeSocket();
      if (connect(end.number(), raw, sizeof address) != 0) __builtin_trap();
      peers.push_back(std::make_unique<Peer>(std::move(end)));
    }
  } else {
    unlink(path.c_str());
    const gt::FileDescriptor listening = makeSocket();
    if (bind(listening.number(), raw, sizeof address) != 0 || listen(listening.number(), 1) != 0)
      __builtin_trap();
    socket = *network.connect("ipc://" + path, "me", {}, limits);
    peers.push_back(std::make_unique<Peer>(
        gt::FileDescriptor{accept4(listening.number(), nullptr, nullptr, SOCK_NONBLOCK)}));
    unlink(path.c_str());
  }
  receiveAll(*socket);
  while (!input.empty()) perform(input, *peers[input.take<std::uint8_t>() % peers.size()], *socket);
  receiveAll(*socket);
  return 0;
}
