#include "network/QueueStream.h"

#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace gt {
namespace {

constexpr std::size_t headerSize = 4;

Error failure(const char* what) {
  return {.what = std::string{what} + ": " + std::strerror(errno)};
}

bool wouldBlock() {
  return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
}

}  // namespace

QueueStream::QueueStream(FileDescriptor socket, const Vocabulary& own, std::size_t capacity,
                         std::optional<Milliseconds> patience)
    : socket_{std::move(socket)},
      own_{own},
      patience_{patience},
      interpreter_{&own},
      raw_{capacity},
      bytes_(headerSize) {}

Result<void> QueueStream::introduce(const MessageQueue& messages) {
  MessageQueue all{raw_.capacity()};
  all.write(Time{}, own_.descriptions());
  messages.copyAllMessages(all);
  return send(all);
}

Result<void> QueueStream::send(const MessageQueue& messages) {
  const auto begin = Clock::now();
  const auto size = static_cast<std::uint32_t>(messages.size());
  std::byte header[headerSize];
  std::memcpy(header, &size, headerSize);
  std::size_t sent = 0;
  while (sent < headerSize + size) {
    iovec parts[] = {{header, headerSize},
                     {const_cast<std::byte*>(messages.bytes().data()), messages.size()}};
    iovec* first = sent < headerSize ? &parts[0] : &parts[1];
    const std::size_t before = sent < headerSize ? sent : sent - headerSize;
    first->iov_base = static_cast<std::byte*>(first->iov_base) + before;
    first->iov_len -= before;
    msghdr message{};
    message.msg_iov = first;
    message.msg_iovlen = static_cast<std::size_t>(std::end(parts) - first);
    const ssize_t n = sendmsg(socket_.number(), &message, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n < 0 && !wouldBlock()) return failure("cannot be reached");
    if (n >= 0)
      sent += static_cast<std::size_t>(n);
    else if (auto done = waitFor(POLLOUT, begin); !done)
      return done;
  }
  return {};
}

Result<bool> QueueStream::receive(MessageQueue& messages) {
  messages.clear();
  auto begun = receiveBytes(headerSize);
  if (!begun || !*begun) return begun;
  std::uint32_t size = 0;
  std::memcpy(&size, bytes_.data(), headerSize);
  if (size > raw_.capacity()) return Error{.what = "sends more than a queue can hold"};
  if (auto whole = receiveBytes(headerSize + size); !whole || !*whole)
    return whole ? Error{.what = "has ended within a queue"} : whole;
  const std::size_t end = headerSize + size;
  const bool isQueue = raw_.assign({&bytes_[headerSize], size});
  std::memmove(bytes_.data(), &bytes_[end], size_ - end);
  size_ -= end;
  if (!isQueue) return Error{.what = "sends what is no queue of messages"};

  Result<void> learned;
  raw_.removeIf([&](const Message& message) {
    TypeDescriptions theirs;
    if (!message.is<TypeDescriptions>()) return false;
    learned = message.read(theirs);
    if (learned) interpreter_.learn(std::move(theirs));
    return true;
  });
  if (!learned) return learned.error();
  interpreter_.take(raw_, messages);
  return true;
}

/// Waits until so many bytes have come. Returns false if the connection was closed before.
Result<bool> QueueStream::receiveBytes(std::size_t size) {
  constexpr std::size_t atOnce = 1 << 16;
  const auto begin = Clock::now();
  if (bytes_.size() < size + atOnce) bytes_.resize(size + atOnce);
  while (size_ < size) {
    const ssize_t n = recv(socket_.number(), &bytes_[size_], bytes_.size() - size_, MSG_DONTWAIT);
    if (n == 0 || (n < 0 && errno == ECONNRESET)) return false;
    if (n < 0 && !wouldBlock()) return failure("cannot be heard");
    if (n > 0)
      size_ += static_cast<std::size_t>(n);
    else if (auto done = waitFor(POLLIN, begin); !done)
      return done.error();
  }
  return true;
}

Result<void> QueueStream::waitFor(short events, Clock::time_point begin) const {
  pollfd socket{socket_.number(), events, 0};
  int wait = -1;
  if (patience_) {
    const auto left = *patience_ - std::chrono::duration_cast<Milliseconds>(Clock::now() - begin);
    if (left <= Milliseconds{0})
      return Error{.what = "has not answered for " + std::to_string(patience_->count()) + " ms"};
    wait = static_cast<int>(left.count());
  }
  if (poll(&socket, 1, wait) < 0 && errno != EINTR) return failure("cannot be waited for");
  return {};
}

}  // namespace gt
