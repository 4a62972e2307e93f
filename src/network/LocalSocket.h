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

/// A connection with another program on this machine. Small frames pass through a Unix socket; of
/// large ones only a notice does, the package lies in memory that both see (SharedSlot.h). All ends
/// with the connection, however a program ends. What a peer costs is bounded without a guard as
/// ZeroMQ needs it: a message is one datagram and has an end, the operating system lets few wait,
/// and the memory of slots is the peer's.
class LocalConnection {
 public:
  LocalConnection(FileDescriptor socket, const SocketLimits& limits);
  ~LocalConnection();
  LocalConnection(const LocalConnection&) = delete;
  LocalConnection& operator=(const LocalConnection&) = delete;

  /// What came in; `skipped` is a message that is no frame but right, or a package that a newer one
  /// has replaced.
  enum class Outcome { nothing, frame, skipped, garbage, closed };
  /// The next frame; views into the connection's memory until the next one.
  Outcome receive(Frame& frame);
  /// False if it was dropped.
  bool send(const Frame& frame, const RepresentationType& type, const void* value);
  /// The first message: who one is.
  bool greet(std::string_view name);

  const FileDescriptor& socket() const { return socket_; }
  /// Of the peer; nothing until it greeted.
  const std::optional<std::string>& name() const { return name_; }
  void rename(std::string name) { name_ = std::move(name); }

 private:
  struct OutSlot {
    std::uint64_t place;  ///< Of a type and a receiver.
    SlotWriter slot;
    bool known;  ///< To the reader.
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

/// Whether a program listens on a path, as LocalSocket does.
bool somebodyListens(const std::string& path);

/// A socket within this machine, for endpoints as ipc://PATH. Only programs of the same user (or
/// the administrator's) are let in.
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
  FileDescriptor events_;  ///< Readable whenever one of the others is.
  FileDescriptor listening_;
  std::vector<std::unique_ptr<LocalConnection>> connections_;
  std::size_t turn_ = 0;  ///< Whose is next, so that nobody keeps others from being heard.
  std::uint64_t strangers_ = 0;
  std::int64_t tried_ = -1;   ///< When it looked for who is there.
  std::int64_t failed_ = -1;  ///< When it could not let in who is there; -1 if it could.
};

}  // namespace gt
