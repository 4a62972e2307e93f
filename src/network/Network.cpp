#include "network/Network.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <random>

namespace gt {
namespace {

std::int64_t steadyMs() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

std::string binaryKey(const std::string& text) {
  std::string bytes(32, '\0');
  zmq_z85_decode(reinterpret_cast<std::uint8_t*>(bytes.data()), text.c_str());
  return bytes;
}

Error wrong(const std::string& endpoint, const std::string& what) {
  return {"network", 0, endpoint, what};
}

}  // namespace

bool isLocal(std::string_view endpoint) {
  const auto begins = [&](std::string_view text) {
    return endpoint.substr(0, text.size()) == text;
  };
  return begins("ipc://") || begins("inproc://") || begins("tcp://127.") ||
         begins("tcp://localhost:") || begins("tcp://[::1]:");
}

Socket::Socket(Network& network, zmq::socket_type type)
    : network_{network},
      listens_{type == zmq::socket_type::router},
      socket_{network.context_, type} {}

bool Socket::send(std::string_view peer, FrameKind kind, const RepresentationType& type,
                  const void* value) {
  const std::size_t size = value ? type.encodedSize(value) : 0;
  zmq::message_t message{Frame::headerSize + size};
  const auto header = frameHeader({kind, type.id, network_.session(), network_.now, {}});
  std::ranges::copy(header, message.data<std::byte>());
  if (value) type.encodeTo(value, message.data<std::byte>() + Frame::headerSize);
  try {
    if (listens_ &&
        !socket_.send(zmq::buffer(peer), zmq::send_flags::sndmore | zmq::send_flags::dontwait))
      return false;
    return socket_.send(message, zmq::send_flags::dontwait).has_value();
  } catch (const zmq::error_t&) {
    return false;  // the peer is gone
  }
}

bool Socket::receivePart(zmq::message_t& part) {
  try {
    return socket_.recv(part, zmq::recv_flags::dontwait).has_value();
  } catch (const zmq::error_t&) {
    return false;  // interrupted by a signal
  }
}

bool Socket::receive(Received& received) {
  constexpr int mostGarbage = 64;  // then others have their turn first
  for (int garbage = 0; garbage < mostGarbage; ++garbage) {
    if (listens_ && !receivePart(peer_)) return false;
    if (!listens_ || peer_.more()) {
      if (!receivePart(message_)) return false;
      bool whole = !message_.more();
      for (zmq::message_t rest; message_.more() && receivePart(rest) && rest.more();) whole = false;
      const auto frame = parseFrame({message_.data<std::byte>(), message_.size()});
      if (whole && frame) {
        received.peer = listens_ ? peer_.to_string_view() : std::string_view{};
        received.frame = *frame;
        return true;
      }
    }
    ++rejected_;
  }
  return false;
}

Network::Network()
    : session_{std::random_device{}() + (std::uint64_t{std::random_device{}()} << 32)},
      begin_{steadyMs()} {}

Network::~Network() = default;

std::int64_t Network::elapsed() const {
  return steadyMs() - begin_;
}

/// ZeroMQ asks it who may connect (its protocol ZAP).
void Network::makeKeyKeeper() {
  if (keyKeeper_) return;
  keyKeeper_.emplace(context_, zmq::socket_type::rep);
  keyKeeper_->set(zmq::sockopt::linger, 0);
  keyKeeper_->bind("inproc://zeromq.zap.01");
  items_.push_back({keyKeeper_->handle(), 0, ZMQ_POLLIN, 0});
}

void Network::answerKeyQuestions() {
  // Version, number of the question, domain, address, identity, mechanism, and for CURVE the key.
  std::vector<std::string> question;
  zmq::message_t part;
  while (keyKeeper_->recv(part, zmq::recv_flags::dontwait)) {
    question.push_back(part.to_string());
    if (part.more()) continue;
    const bool known = question.size() == 7 && question[5] == "CURVE" &&
                       std::ranges::find(clients_, question[6]) != clients_.end();
    const std::string number = question.size() > 1 ? question[1] : "";
    for (const std::string& text : {std::string{"1.0"}, number, std::string{known ? "200" : "400"},
                                    std::string{known ? "" : "not a known key"}, std::string{}})
      keyKeeper_->send(zmq::buffer(text), zmq::send_flags::sndmore);
    keyKeeper_->send(zmq::message_t{}, zmq::send_flags::none);
    question.clear();
  }
}

Result<Socket*> Network::listen(const std::string& endpoint, const std::optional<Keys>& keys,
                                const SocketLimits& limits) {
  if (!keys && !isLocal(endpoint))
    return wrong(endpoint,
                 "can be reached from other machines: needs keys (router --make-keys FOLDER)");
  if (keys && !keys->canListen()) return wrong(endpoint, "these keys are not for listening");
  std::unique_ptr<Socket> socket{new Socket{*this, zmq::socket_type::router}};
  // A program that was started again takes the place of the one before it.
  socket->socket_.set(zmq::sockopt::router_handover, true);
  if (keys) {
    makeKeyKeeper();
    clients_.push_back(binaryKey(keys->clientPublic));
    socket->socket_.set(zmq::sockopt::curve_server, true);
    socket->socket_.set(zmq::sockopt::curve_secretkey, keys->serverSecret);
    socket->socket_.set(zmq::sockopt::zap_domain, "gt2003");
  }
  return add(std::move(socket), endpoint, limits);
}

Result<Socket*> Network::connect(const std::string& endpoint, const std::string& name,
                                 const std::optional<Keys>& keys, const SocketLimits& limits) {
  if (keys && !keys->canConnect()) return wrong(endpoint, "these keys are not for connecting");
  std::unique_ptr<Socket> socket{new Socket{*this, zmq::socket_type::dealer}};
  if (!name.empty()) socket->socket_.set(zmq::sockopt::routing_id, name);
  socket->socket_.set(zmq::sockopt::immediate, true);  // nothing waits for who is not there
  socket->socket_.set(zmq::sockopt::reconnect_ivl, 20);
  socket->socket_.set(zmq::sockopt::reconnect_ivl_max, 500);
  if (keys) {
    socket->socket_.set(zmq::sockopt::curve_serverkey, keys->serverPublic);
    socket->socket_.set(zmq::sockopt::curve_publickey, keys->clientPublic);
    socket->socket_.set(zmq::sockopt::curve_secretkey, keys->clientSecret);
  }
  return add(std::move(socket), endpoint, limits);
}

Result<Socket*> Network::add(std::unique_ptr<Socket> socket, const std::string& endpoint,
                             const SocketLimits& limits) {
  zmq::socket_t& raw = socket->socket_;
  raw.set(zmq::sockopt::linger, 0);
  raw.set(zmq::sockopt::sndhwm, limits.frames);
  raw.set(zmq::sockopt::rcvhwm, limits.frames);
  raw.set(zmq::sockopt::maxmsgsize, limits.frameSize);
  raw.set(zmq::sockopt::heartbeat_ivl, 2000);
  raw.set(zmq::sockopt::heartbeat_timeout, 6000);
  raw.set(zmq::sockopt::handshake_ivl, 5000);
  try {
    if (socket->listens_)
      raw.bind(endpoint);
    else
      raw.connect(endpoint);
  } catch (const zmq::error_t& error) {
    return wrong(endpoint, error.what());
  }
  items_.push_back({raw.handle(), 0, ZMQ_POLLIN, 0});
  sockets_.push_back(std::move(socket));
  return sockets_.back().get();
}

void Network::wait(std::int64_t ms) {
  try {
    zmq::poll(items_, std::chrono::milliseconds{ms});
    if (keyKeeper_) answerKeyQuestions();
  } catch (const zmq::error_t&) {
    // Interrupted by a signal: the program looks what to do.
  }
}

}  // namespace gt
