#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/FileDescriptor.h"
#include "base/Result.h"
#include "network/SharedSlot.h"
#include "network/Socket.h"

namespace gt {

/// A connection with another program on this machine. Small frames are sent through a Unix socket.
/// For a large frame only a notice is sent, and the package is passed in shared memory
/// (SharedSlot.h). All resources end with the connection, however a program ends. Unlike ZeroMQ, it
/// needs no guard against malicious peers: a message is one datagram of limited size, the operating
/// system limits how many wait, and the memory of slots belongs to the peer.
class LocalConnection {
 public:
  LocalConnection(FileDescriptor socket, const SocketLimits& limits);
  ~LocalConnection();
  LocalConnection(const LocalConnection&) = delete;
  LocalConnection& operator=(const LocalConnection&) = delete;

  /// The result of receive(). skipped: a valid message that is not a frame, or a package that a
  /// newer one has replaced; garbage: an invalid message.
  enum class Outcome { nothing, frame, skipped, garbage, closed };
  /// Receives the next frame. It refers to the connection's memory and is valid until the next
  /// call.
  Outcome receive(Frame& frame);
  /// Sends a frame. Returns false if it was dropped.
  bool send(const Frame& frame, const RepresentationType& type, const void* value);
  /// Sends the first message, which contains the own name.
  bool greet(std::string_view name);

  const FileDescriptor& socket() const { return socket_; }
  /// Name of the peer; empty until it has greeted.
  const std::optional<std::string>& name() const { return name_; }
  void rename(std::string name) { name_ = std::move(name); }

 private:
  struct OutSlot {
    std::uint64_t place;  ///< Identifies type and receiver.
    SlotWriter slot;
    bool known;  ///< Whether the reader knows the slot.
  };
  struct InSlot {
    std::uint64_t place;
    SlotReader slot;
  };

  struct Batch;

  bool refill();
  OutSlot* slotFor(std::uint64_t place, std::size_t size);
  bool sendMessage(std::size_t size, const FileDescriptor* memory);
  Outcome take(std::span<const std::byte> message, FileDescriptor memory, Frame& frame);
  Outcome takeShared(std::span<const std::byte> message, FileDescriptor memory, Frame& frame);
  bool keepSlot(std::uint64_t place, const FileDescriptor& memory);

  FileDescriptor socket_;
  SocketLimits limits_;
  std::optional<std::string> name_;
  std::vector<OutSlot> out_;
  std::vector<InSlot> in_;
  std::vector<std::byte> outgoing_, package_;
  std::unique_ptr<Batch> batch_;
};

/// Whether a program listens on a path in the way LocalSocket does.
bool somebodyListens(const std::string& path);

/// A socket on this machine, for endpoints of the form ipc://PATH. Only programs of the same user
/// or of the administrator may connect.
class LocalSocket : public Socket {
 public:
  static Result<std::unique_ptr<Socket>> listen(const Network& network, const std::string& path,
                                                const SocketLimits& limits);
  static Result<std::unique_ptr<Socket>> connect(const Network& network, const std::string& path,
                                                 const std::string& name,
                                                 const SocketLimits& limits);
  ~LocalSocket() override;

  bool send(std::string_view peer, FrameKind kind, const Topic& topic, const void* value) override;
  bool receive(Received& received) override;
  std::string endpoint() const override { return "ipc://" + path_; }
  int file() const override { return events_.number(); }

 private:
  LocalSocket(const Network& network, std::string path, const SocketLimits& limits);
  Result<void> bind();
  void accept();
  void watchListening(bool on);
  void connectAgain();
  bool hasRoom();
  void add(FileDescriptor socket);
  bool listens() const { return static_cast<bool>(listening_); }
  void welcome(LocalConnection& connection);

  std::string path_, name_;
  SocketLimits limits_;
  FileDescriptor events_;  ///< Readable when at least one of the other descriptors is.
  FileDescriptor listening_;
  std::vector<std::unique_ptr<LocalConnection>> connections_;
  std::size_t turn_ = 0;  ///< Connection to be served next, so that all are served in turn.
  std::uint64_t strangers_ = 0;
  std::int64_t tried_ = -1;   ///< Time of the last attempt to accept or to connect.
  std::int64_t failed_ = -1;  ///< When it could not let in who is there; -1 if it could.
};

}  // namespace gt
