#include "network/ZeroMq.h"

#include <algorithm>

#include "network/Network.h"

namespace gt {
namespace {

std::string binaryKey(const std::string& text) {
  std::string bytes(32, '\0');
  zmq_z85_decode(reinterpret_cast<std::uint8_t*>(bytes.data()), text.c_str());
  return bytes;
}

Error wrong(const std::string& endpoint, const std::string& what) {
  return {"network", 0, endpoint, what};
}

}  // namespace

void ZeroMq::guard(zmq::socket_t& socket, const Keys& keys) {
  if (!keyKeeper_) {
    keyKeeper_.emplace(context_, zmq::socket_type::rep);
    keyKeeper_->set(zmq::sockopt::linger, 0);
    keyKeeper_->bind("inproc://zeromq.zap.01");
  }
  clients_.push_back(binaryKey(keys.clientPublic));
  socket.set(zmq::sockopt::curve_server, true);
  socket.set(zmq::sockopt::curve_secretkey, keys.serverSecret);
  socket.set(zmq::sockopt::zap_domain, "gt2003");
}

void ZeroMq::answerKeyQuestions() {
  if (!keyKeeper_) return;
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

ZeroMqSocket::ZeroMqSocket(const Network& network, ZeroMq& zeroMq, zmq::socket_type type,
                           const SocketLimits& limits)
    : Socket{network}, listens_{type == zmq::socket_type::router}, socket_{zeroMq.context(), type} {
  socket_.set(zmq::sockopt::linger, 0);
  socket_.set(zmq::sockopt::sndhwm, limits.frames);
  socket_.set(zmq::sockopt::rcvhwm, limits.frames);
  socket_.set(zmq::sockopt::maxmsgsize, limits.frameSize);
  socket_.set(zmq::sockopt::heartbeat_ivl, 2000);
  socket_.set(zmq::sockopt::heartbeat_timeout, 6000);
  socket_.set(zmq::sockopt::handshake_ivl, 5000);
}

Result<std::unique_ptr<Socket>> ZeroMqSocket::listen(const Network& network, ZeroMq& zeroMq,
                                                     const std::string& endpoint,
                                                     const std::optional<Keys>& keys,
                                                     const SocketLimits& limits) {
  std::unique_ptr<ZeroMqSocket> socket{
      new ZeroMqSocket{network, zeroMq, zmq::socket_type::router, limits}};
  // A program that was started again takes the place of the one before it.
  socket->socket_.set(zmq::sockopt::router_handover, true);
  if (keys) zeroMq.guard(socket->socket_, *keys);
  try {
    socket->socket_.bind(endpoint);
  } catch (const zmq::error_t& error) {
    return wrong(endpoint, error.what());
  }
  return std::unique_ptr<Socket>{std::move(socket)};
}

Result<std::unique_ptr<Socket>> ZeroMqSocket::connect(const Network& network, ZeroMq& zeroMq,
                                                      const std::string& endpoint,
                                                      const std::string& name,
                                                      const std::optional<Keys>& keys,
                                                      const SocketLimits& limits) {
  std::unique_ptr<ZeroMqSocket> socket{
      new ZeroMqSocket{network, zeroMq, zmq::socket_type::dealer, limits}};
  zmq::socket_t& raw = socket->socket_;
  if (!name.empty()) raw.set(zmq::sockopt::routing_id, name);
  raw.set(zmq::sockopt::immediate, true);  // nothing waits for who is not there
  raw.set(zmq::sockopt::reconnect_ivl, 20);
  raw.set(zmq::sockopt::reconnect_ivl_max, 500);
  if (keys) {
    raw.set(zmq::sockopt::curve_serverkey, keys->serverPublic);
    raw.set(zmq::sockopt::curve_publickey, keys->clientPublic);
    raw.set(zmq::sockopt::curve_secretkey, keys->clientSecret);
  }
  try {
    raw.connect(endpoint);
  } catch (const zmq::error_t& error) {
    return wrong(endpoint, error.what());
  }
  return std::unique_ptr<Socket>{std::move(socket)};
}

bool ZeroMqSocket::send(std::string_view peer, FrameKind kind, const RepresentationType& type,
                        const void* value) {
  const std::size_t size = value ? type.encodedSize(value) : 0;
  zmq::message_t message{Frame::headerSize + size};
  std::ranges::copy(frameHeader(frame(kind, type)), message.data<std::byte>());
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

bool ZeroMqSocket::receivePart(zmq::message_t& part) {
  try {
    return socket_.recv(part, zmq::recv_flags::dontwait).has_value();
  } catch (const zmq::error_t&) {
    return false;  // interrupted by a signal
  }
}

bool ZeroMqSocket::receive(Received& received) {
  constexpr int mostGarbage = 64;  // then others have their turn first
  for (int garbage = 0; garbage < mostGarbage; ++garbage) {
    if (listens_ && !receivePart(peer_)) return false;
    if (!listens_ || peer_.more()) {
      if (!receivePart(message_)) return false;
      bool whole = !message_.more();
      for (zmq::message_t rest; message_.more() && receivePart(rest) && rest.more();) whole = false;
      const auto parsed = parseFrame({message_.data<std::byte>(), message_.size()});
      if (whole && parsed) {
        received.peer = listens_ ? peer_.to_string_view() : std::string_view{};
        received.frame = *parsed;
        return true;
      }
    }
    ++rejected_;
  }
  return false;
}

}  // namespace gt
