#include "network/Network.h"

#include <chrono>
#include <random>
#include <thread>

#include "network/LocalSocket.h"
#include "network/ZeroMq.h"

namespace gt {
namespace {

constexpr std::string_view localScheme = "ipc://";

std::int64_t steadyMs() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

Error wrong(const std::string& endpoint, const std::string& what) {
  return {.file = "network", .field = endpoint, .what = what};
}

bool begins(std::string_view endpoint, std::string_view text) {
  return endpoint.substr(0, text.size()) == text;
}

}  // namespace

bool isLocal(std::string_view endpoint) {
  return begins(endpoint, localScheme) || begins(endpoint, "inproc://") ||
         begins(endpoint, "tcp://127.") || begins(endpoint, "tcp://localhost:") ||
         begins(endpoint, "tcp://[::1]:");
}

std::string_view describe(Refusal reason) {
  switch (reason) {
    case Refusal::wrongKey:
      return "the key does not fit, or one of both sides has none";
    case Refusal::unknownKey:
      return "the key is not known";
    case Refusal::otherUser:
      return "another user's program";
    case Refusal::noPlace:
      return "all places are taken";
    case Refusal::share:
      return "too many from one address";
    case Refusal::endless:
      return "a message without an end";
    case Refusal::silent:
      break;
  }
  return "sent nothing";
}

std::string describe(const Refusals& refusals) {
  std::uint64_t sum = 0;
  std::string text;
  for (std::size_t i = 0; i < enumCount<Refusal>; ++i) {
    const auto reason = static_cast<Refusal>(i);
    if (refusals[reason] == 0) continue;
    sum += refusals[reason];
    text += (text.empty() ? "" : ", ") + std::to_string(refusals[reason]) + " ";
    text += describe(reason);
  }
  return sum == 0 ? "" : std::to_string(sum) + " refused: " + text;
}

Frame Socket::frame(FrameKind kind, const Topic& topic) const {
  return {kind, topic.type->id, network_.session(), network_.now, {}, topic.schema, topic.receiver};
}

Network::Network()
    : session_{std::random_device{}() + (std::uint64_t{std::random_device{}()} << 32)},
      begin_{steadyMs()} {}

Network::~Network() = default;

std::int64_t Network::elapsed() const {
  return steadyMs() - begin_;
}

ZeroMq& Network::zeroMq() {
  if (!zeroMq_) zeroMq_ = std::make_unique<ZeroMq>();
  return *zeroMq_;
}

Result<Socket*> Network::listen(const std::string& endpoint, const std::optional<Keys>& keys,
                                const SocketLimits& limits) {
  if (begins(endpoint, localScheme))
    return add(LocalSocket::listen(*this, endpoint.substr(localScheme.size()), limits));
  if (!keys && !isLocal(endpoint))
    return wrong(endpoint,
                 "can be reached from other machines: needs keys (router --make-keys FOLDER)");
  if (keys && !keys->canListen()) return wrong(endpoint, "these keys are not for listening");
  return add(ZeroMqSocket::listen(*this, zeroMq(), endpoint, keys, limits));
}

Result<Socket*> Network::connect(const std::string& endpoint, const std::string& name,
                                 const std::optional<Keys>& keys, const SocketLimits& limits) {
  if (begins(endpoint, localScheme))
    return add(LocalSocket::connect(*this, endpoint.substr(localScheme.size()), name, limits));
  if (keys && !keys->canConnect()) return wrong(endpoint, "these keys are not for connecting");
  return add(ZeroMqSocket::connect(*this, zeroMq(), endpoint, name, keys, limits));
}

Result<Socket*> Network::add(Result<std::unique_ptr<Socket>> socket) {
  if (!socket) return socket.error();
  sockets_.push_back(std::move(*socket));
  return sockets_.back().get();
}

void Network::wait(std::int64_t ms, std::int64_t shortest) {
  if (const std::int64_t rest = woken_ + shortest - elapsed(); rest > 0)
    std::this_thread::sleep_for(std::chrono::milliseconds{rest});
  waitedFor_.clear();
  for (const auto& socket : sockets_)
    waitedFor_.push_back({socket->zeroMq(), socket->file(), ZMQ_POLLIN, 0});
  if (void* questions = zeroMq_ ? zeroMq_->questions() : nullptr)
    waitedFor_.push_back({questions, 0, ZMQ_POLLIN, 0});
  try {
    zmq::poll(waitedFor_, std::chrono::milliseconds{ms});
    if (zeroMq_) zeroMq_->answerKeyQuestions();
  } catch (const zmq::error_t&) {
    // Interrupted by a signal: the program looks what to do.
  }
  woken_ = elapsed();
}

}  // namespace gt
