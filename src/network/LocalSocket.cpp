#include "network/LocalSocket.h"

#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "network/Network.h"

namespace gt {
namespace {

/// The first message of who connects: this, then its name.
constexpr std::string_view greeting = "GT-local-2 ";
constexpr std::size_t longestName = 64;
/// Larger packages go through shared memory.
constexpr std::size_t inlineSize = 4096;
/// A robot's processes exchange less types of large packages.
constexpr std::size_t mostSlots = 32;
/// Where nobody listens one tries again, in ms.
constexpr std::int64_t retryAfter = 20;
/// Without descriptors, until the next connection is accepted, in ms.
constexpr std::int64_t acceptAfter = 100;

/// Before each frame: of a package in shared memory the number by which it is read, and its size.
struct Notice {
  std::uint64_t number = 0;
  std::uint64_t size = 0;
};
constexpr std::size_t headSize = sizeof(Notice) + Frame::headerSize;

Error failed(const std::string& path, const std::string& what) {
  return {.file = "network", .field = "ipc://" + path, .what = what};
}

std::optional<sockaddr_un> addressOf(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.empty() || path.size() >= sizeof address.sun_path) return {};
  std::ranges::copy(path, address.sun_path);
  return address;
}

/// Packages of one type for one receiver share a slot.
std::uint64_t placeOf(const Frame& frame) {
  return std::uint64_t{frame.receiver} << 32 | frame.type;
}

FileDescriptor makeSocket() {
  return FileDescriptor{::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)};
}

bool connectTo(const FileDescriptor& socket, const sockaddr_un& address) {
  return ::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address) ==
         0;
}

/// Only programs of the same user are let in, and of the administrator, who could anyway.
bool isTrusted(const FileDescriptor& socket) {
  ucred peer{};
  socklen_t size = sizeof peer;
  return getsockopt(socket.number(), SOL_SOCKET, SO_PEERCRED, &peer, &size) == 0 &&
         (peer.uid == geteuid() || peer.uid == 0);
}

/// Room for what comes beside a message: descriptors, of which one is expected.
using Control = std::array<std::byte, CMSG_SPACE(sizeof(int))>;

/// The first descriptor that came with a message; others are closed.
FileDescriptor descriptorOf(msghdr& message) {
  FileDescriptor first;
  for (cmsghdr* part = CMSG_FIRSTHDR(&message); part; part = CMSG_NXTHDR(&message, part)) {
    if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_RIGHTS) continue;
    for (std::size_t at = CMSG_LEN(0); at + sizeof(int) <= part->cmsg_len; at += sizeof(int)) {
      int number = -1;
      std::memcpy(&number, reinterpret_cast<const std::byte*>(part) + at, sizeof number);
      FileDescriptor descriptor{number};
      if (!first) first = std::move(descriptor);
    }
  }
  return first;
}

}  // namespace

bool somebodyListens(const std::string& path) {
  const auto address = addressOf(path);
  return address && connectTo(makeSocket(), *address);
}

/// Messages that came in, taken from the operating system at one go.
struct LocalConnection::Batch {
  static constexpr std::size_t size = 8;

  struct Message {
    std::array<std::byte, headSize + inlineSize> bytes;
    iovec part;
    alignas(cmsghdr) Control control;
  };
  std::array<Message, size> messages;
  std::array<mmsghdr, size> heads{};
  std::size_t next = 0, count = 0;
  bool last = false;  ///< Nothing was left when it was taken.
};

LocalConnection::LocalConnection(FileDescriptor socket, const SocketLimits& limits)
    : socket_{std::move(socket)},
      limits_{limits},
      outgoing_(headSize + inlineSize),
      batch_{std::make_unique<Batch>()} {}

LocalConnection::~LocalConnection() {
  while (batch_->next < batch_->count) descriptorOf(batch_->heads[batch_->next++].msg_hdr);
}

bool LocalConnection::greet(std::string_view name) {
  std::string text{greeting};
  text += name.substr(0, longestName);
  return ::send(socket_.number(), text.data(), text.size(), MSG_DONTWAIT | MSG_NOSIGNAL) >= 0;
}

bool LocalConnection::send(const Frame& frame, const RepresentationType& type, const void* value) {
  const std::size_t size = value ? type.encodedSize(value) : 0;
  Notice notice;
  OutSlot* slot = nullptr;
  if (size > inlineSize) {
    slot = slotFor(placeOf(frame), size);
    if (!slot) return false;
    type.encodeTo(value, slot->slot.begin());
    notice = {slot->slot.publish(), size};
  } else if (value) {
    type.encodeTo(value, &outgoing_[headSize]);
  }
  std::memcpy(outgoing_.data(), &notice, sizeof notice);
  std::ranges::copy(frameHeader(frame), &outgoing_[sizeof notice]);
  const bool isNew = slot && !slot->known;
  if (!sendMessage(slot ? headSize : headSize + size, isNew ? &slot->slot.memory() : nullptr))
    return false;
  if (slot) slot->known = true;
  return true;
}

bool LocalConnection::sendMessage(std::size_t size, const FileDescriptor* memory) {
  constexpr int flags = MSG_DONTWAIT | MSG_NOSIGNAL;
  if (!memory) return ::send(socket_.number(), outgoing_.data(), size, flags) >= 0;
  iovec part{outgoing_.data(), size};
  msghdr message{};
  message.msg_iov = &part;
  message.msg_iovlen = 1;
  alignas(cmsghdr) Control control{};
  message.msg_control = control.data();
  message.msg_controllen = control.size();
  cmsghdr* beside = CMSG_FIRSTHDR(&message);
  beside->cmsg_level = SOL_SOCKET;
  beside->cmsg_type = SCM_RIGHTS;
  beside->cmsg_len = CMSG_LEN(sizeof(int));
  const int number = memory->number();
  std::memcpy(CMSG_DATA(beside), &number, sizeof number);
  return sendmsg(socket_.number(), &message, flags) >= 0;
}

/// A package that does not fit in the slot of its type gets a larger one.
LocalConnection::OutSlot* LocalConnection::slotFor(std::uint64_t place, std::size_t size) {
  if (size > static_cast<std::size_t>(limits_.frameSize)) return nullptr;
  const auto slot = std::ranges::find(out_, place, &OutSlot::place);
  if (slot != out_.end() && slot->slot.capacity() >= size) return &*slot;
  auto made = SlotWriter::make(size);
  if (!made) return nullptr;
  if (slot == out_.end()) return &out_.emplace_back(OutSlot{place, std::move(*made), false});
  *slot = {place, std::move(*made), false};
  return &*slot;
}

/// Takes the next messages from the operating system; false if the connection has ended.
bool LocalConnection::refill() {
  for (std::size_t i = 0; i < Batch::size; ++i) {
    Batch::Message& message = batch_->messages[i];
    message.part = {message.bytes.data(), message.bytes.size()};
    batch_->heads[i].msg_hdr = {
        nullptr, 0, &message.part, 1, message.control.data(), message.control.size(), 0};
  }
  const int count = recvmmsg(socket_.number(), batch_->heads.data(), Batch::size,
                             MSG_DONTWAIT | MSG_CMSG_CLOEXEC, nullptr);
  batch_->next = 0;
  batch_->count = count > 0 ? static_cast<std::size_t>(count) : 0;
  batch_->last = batch_->count > 0 && batch_->count < Batch::size;
  return count >= 0 || errno == EAGAIN || errno == EINTR;
}

LocalConnection::Outcome LocalConnection::receive(Frame& frame) {
  if (batch_->next == batch_->count) {
    // Who asks until nothing is there does not ask the operating system for that.
    if (std::exchange(batch_->last, false)) return Outcome::nothing;
    if (!refill()) return Outcome::closed;
    if (batch_->count == 0) return Outcome::nothing;
  }
  const std::size_t index = batch_->next++;
  mmsghdr& head = batch_->heads[index];
  FileDescriptor memory = descriptorOf(head.msg_hdr);
  if (head.msg_len == 0) return Outcome::closed;
  if (head.msg_hdr.msg_flags & MSG_TRUNC) return Outcome::garbage;
  return take({batch_->messages[index].bytes.data(), head.msg_len}, std::move(memory), frame);
}

LocalConnection::Outcome LocalConnection::take(std::span<const std::byte> message,
                                               FileDescriptor memory, Frame& frame) {
  const std::string_view text{reinterpret_cast<const char*>(message.data()), message.size()};
  if (!name_ && text.substr(0, greeting.size()) == greeting) {
    name_ = text.substr(greeting.size(), longestName);
    return Outcome::skipped;
  }
  if (!name_ || message.size() < headSize) return Outcome::garbage;
  const auto parsed = parseFrame(message.subspan(sizeof(Notice)));
  if (!parsed) return Outcome::garbage;
  frame = *parsed;
  return takeShared(message, std::move(memory), frame);
}

LocalConnection::Outcome LocalConnection::takeShared(std::span<const std::byte> message,
                                                     FileDescriptor memory, Frame& frame) {
  Notice notice;
  std::memcpy(&notice, message.data(), sizeof notice);
  if (notice.number == 0) return Outcome::frame;
  if (memory && !keepSlot(placeOf(frame), memory)) return Outcome::garbage;
  const auto slot = std::ranges::find(in_, placeOf(frame), &InSlot::place);
  if (slot == in_.end() || notice.size == 0 || notice.size > slot->slot.size())
    return Outcome::garbage;
  if (package_.size() < notice.size) package_.resize(notice.size);
  frame.bytes = {package_.data(), notice.size};
  // What was replaced before it could be read is no garbage: the notice of the next one follows.
  const bool read = slot->slot.read(notice.number, {package_.data(), notice.size});
  return read ? Outcome::frame : Outcome::skipped;
}

/// All slots together are limited, as is each of them.
bool LocalConnection::keepSlot(std::uint64_t place, const FileDescriptor& memory) {
  const auto largest = static_cast<std::size_t>(limits_.frameSize);
  auto slot = SlotReader::open(memory, largest);
  if (!slot) return false;
  std::size_t sum = slot->size();
  for (const InSlot& other : in_) sum += other.place == place ? 0 : other.slot.size();
  if (sum > 8 * largest) return false;
  const auto old = std::ranges::find(in_, place, &InSlot::place);
  if (old == in_.end() && in_.size() >= mostSlots) return false;
  if (old == in_.end())
    in_.push_back({place, std::move(*slot)});
  else
    old->slot = std::move(*slot);
  return true;
}

LocalSocket::LocalSocket(const Network& network, std::string path, const SocketLimits& limits)
    : Socket{network},
      path_{std::move(path)},
      limits_{limits},
      events_{epoll_create1(EPOLL_CLOEXEC)} {}

LocalSocket::~LocalSocket() {
  if (listens()) unlink(path_.c_str());
}

Result<std::unique_ptr<Socket>> LocalSocket::listen(const Network& network, const std::string& path,
                                                    const SocketLimits& limits) {
  std::unique_ptr<LocalSocket> socket{new LocalSocket{network, path, limits}};
  if (auto done = socket->bind(); !done) return done.error();
  return std::unique_ptr<Socket>{std::move(socket)};
}

Result<std::unique_ptr<Socket>> LocalSocket::connect(const Network& network,
                                                     const std::string& path,
                                                     const std::string& name,
                                                     const SocketLimits& limits) {
  if (!addressOf(path)) return failed(path, "is no path for a socket, or too long");
  std::unique_ptr<LocalSocket> socket{new LocalSocket{network, path, limits}};
  socket->name_ = name;
  socket->connectAgain();
  return std::unique_ptr<Socket>{std::move(socket)};
}

/// What a killed program left behind is taken away, but nobody who still listens is replaced.
Result<void> LocalSocket::bind() {
  const auto address = addressOf(path_);
  if (!address) return failed(path_, "is no path for a socket, or too long");
  if (somebodyListens(path_)) return failed(path_, "another program listens there");
  std::error_code missing;
  if (std::filesystem::is_socket(std::filesystem::symlink_status(path_, missing)))
    unlink(path_.c_str());
  FileDescriptor socket = makeSocket();
  if (::bind(socket.number(), reinterpret_cast<const sockaddr*>(&*address), sizeof *address) != 0 ||
      ::listen(socket.number(), static_cast<int>(limits_.peers)) != 0)
    return failed(path_, std::strerror(errno));
  epoll_event event{EPOLLIN, {}};
  if (epoll_ctl(events_.number(), EPOLL_CTL_ADD, socket.number(), &event) != 0)
    return failed(path_, std::strerror(errno));
  listening_ = std::move(socket);
  return {};
}

void LocalSocket::add(FileDescriptor socket) {
  epoll_event event{EPOLLIN, {}};
  if (epoll_ctl(events_.number(), EPOLL_CTL_ADD, socket.number(), &event) == 0)
    connections_.push_back(std::make_unique<LocalConnection>(std::move(socket), limits_));
}

void LocalSocket::accept() {
  // Not each time that somebody looks for frames.
  const std::int64_t now = network_.elapsed();
  if (now == std::exchange(tried_, now) || (failed_ >= 0 && now - failed_ < acceptAfter)) return;
  if (std::exchange(failed_, -1) >= 0) watchListening(true);
  while (true) {
    FileDescriptor socket{
        accept4(listening_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)};
    if (!socket) break;
    if (!isTrusted(socket))
      ++refusals_[Refusal::otherUser];
    else if (!hasRoom())
      ++refusals_[Refusal::noPlace];
    else
      add(std::move(socket));
  }
  if (errno != EMFILE && errno != ENFILE && errno != ENOBUFS && errno != ENOMEM) return;
  // Whoever waits would wake the program again and again.
  failed_ = now;
  watchListening(false);
}

/// Whether somebody who connects wakes the program.
void LocalSocket::watchListening(bool on) {
  epoll_event event{on ? EPOLLIN : 0u, {}};
  epoll_ctl(events_.number(), EPOLL_CTL_MOD, listening_.number(), &event);
}

/// Who has not told a name yet leaves for who comes later.
bool LocalSocket::hasRoom() {
  if (connections_.size() < limits_.peers) return true;
  const auto stranger =
      std::ranges::find_if(connections_, [](const auto& c) { return !c->name(); });
  if (stranger == connections_.end()) return false;
  connections_.erase(stranger);
  ++refusals_[Refusal::silent];
  return true;
}

void LocalSocket::connectAgain() {
  const std::int64_t now = network_.elapsed();
  if (!connections_.empty() || (tried_ >= 0 && now - tried_ < retryAfter)) return;
  tried_ = now;
  FileDescriptor socket = makeSocket();
  if (!connectTo(socket, *addressOf(path_))) return;
  add(std::move(socket));
  if (!connections_.empty() && !connections_.front()->greet(name_)) connections_.clear();
  if (!connections_.empty()) connections_.front()->rename("");
}

bool LocalSocket::send(std::string_view peer, FrameKind kind, const Topic& topic,
                       const void* value) {
  if (!listens()) connectAgain();
  for (const auto& connection : connections_)
    if (!listens() || connection->name() == peer)
      return connection->send(frame(kind, topic), *topic.type, value);
  return false;
}

bool LocalSocket::receive(Received& received) {
  constexpr int mostSkipped = 64;  // then others have their turn first
  if (!listens()) connectAgain();
  int skipped = 0;
  for (std::size_t empty = 0; empty < connections_.size() && skipped < mostSkipped;) {
    turn_ %= connections_.size();
    LocalConnection& connection = *connections_[turn_];
    const bool stranger = !connection.name();
    const auto outcome = connection.receive(received.frame);
    if (outcome == LocalConnection::Outcome::closed) {
      connections_.erase(connections_.begin() + static_cast<std::ptrdiff_t>(turn_));
      continue;
    }
    ++turn_;
    if (stranger && connection.name()) welcome(connection);
    if (outcome == LocalConnection::Outcome::frame) {
      received.peer = *connection.name();
      received.address = {};
      return true;
    }
    rejected_ += outcome == LocalConnection::Outcome::garbage;
    if (outcome == LocalConnection::Outcome::nothing)
      ++empty;
    else
      ++skipped;
  }
  if (listens()) accept();
  return false;
}

/// A program that was started again takes the place of the one before it; who has no name gets one.
void LocalSocket::welcome(LocalConnection& connection) {
  if (connection.name()->empty() || connection.name()->front() == '#')
    connection.rename("#" + std::to_string(++strangers_));
  std::erase_if(connections_, [&](const auto& other) {
    return other.get() != &connection && other->name() == connection.name();
  });
}

}  // namespace gt
