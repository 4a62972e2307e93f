#include "network/ZeroMq.h"

#include <linux/tcp.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstring>

#include "network/LoopbackPeer.h"
#include "network/Network.h"

namespace gt {
namespace {

std::string binaryKey(const std::string& text) {
  std::string bytes(32, '\0');
  zmq_z85_decode(reinterpret_cast<std::uint8_t*>(bytes.data()), text.c_str());
  return bytes;
}

Error endpointError(const std::string& endpoint, const std::string& what) {
  return {.file = "network", .field = endpoint, .what = what};
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

SocketEvents::SocketEvents(ZeroMq& zeroMq, zmq::socket_t& watched, int kinds)
    : events_{zeroMq.context(), zmq::socket_type::pair} {
  const std::string place =
      "inproc://events-" + std::to_string(reinterpret_cast<std::uintptr_t>(this));
  events_.set(zmq::sockopt::linger, 0);
  if (zmq_socket_monitor(watched.handle(), place.c_str(), kinds) == 0) events_.connect(place);
}

std::optional<SocketEvents::Event> SocketEvents::next() {
  zmq::message_t message, address;
  while (events_.recv(message, zmq::recv_flags::dontwait)) {
    if (message.more() && !events_.recv(address)) return {};
    Event event;
    if (message.size() != sizeof event.kind + sizeof event.value) continue;
    std::memcpy(&event.kind, message.data(), sizeof event.kind);
    std::memcpy(&event.value, message.data<std::byte>() + sizeof event.kind, sizeof event.value);
    return event;
  }
  return {};
}

ConnectionGuard::ConnectionGuard(ZeroMq& zeroMq, zmq::socket_t& watched, const SocketLimits& limits,
                                 bool usersOnly)
    : limits_{limits},
      usersOnly_{usersOnly},
      events_{zeroMq, watched, ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_DISCONNECTED} {}

void ConnectionGuard::takeEvents() {
  while (const auto event = events_.next()) {
    std::erase_if(connections_, [&](const Connection& c) { return c.file == event->value; });
    if (event->kind != ZMQ_EVENT_ACCEPTED) continue;
    if (hasRoom())
      connections_.push_back({event->value});
    else
      shutdown(event->value, SHUT_RDWR);
  }
}

/// Who has sent nothing yet leaves for who comes later.
bool ConnectionGuard::hasRoom() {
  if (connections_.size() < limits_.peers) return true;
  const auto stranger =
      std::ranges::find_if(connections_, [](const Connection& c) { return !c.known; });
  if (stranger == connections_.end()) return false;
  drop(stranger);
  return true;
}

void ConnectionGuard::drop(std::vector<Connection>::iterator connection) {
  shutdown(connection->file, SHUT_RDWR);
  connections_.erase(connection);
}

bool ConnectionGuard::admits(int connection) {
  takeEvents();
  const auto found = std::ranges::find(connections_, connection, &Connection::file);
  if (found == connections_.end()) return false;
  // Whose it is takes long to find out: not for each of thousands who connect and send nothing.
  if (!found->known && usersOnly_ && !isPeerOfThisUser(connection)) {
    drop(found);
    return false;
  }
  return found->known = found->heard = true;
}

bool ConnectionGuard::isTolerable(Connection& connection) const {
  constexpr std::int64_t slack = 1'000'000;  // what is under way, and the frames' heads
  tcp_info info{};
  socklen_t size = sizeof info;
  if (getsockopt(connection.file, IPPROTO_TCP, TCP_INFO, &info, &size) != 0) return true;
  const auto bytes = static_cast<std::int64_t>(info.tcpi_bytes_received);
  if (std::exchange(connection.heard, false) || bytes < connection.bytes) connection.bytes = bytes;
  return bytes - connection.bytes <= limits_.frameSize + slack;
}

void ConnectionGuard::check() {
  takeEvents();
  for (Connection& connection : connections_)
    if (!isTolerable(connection)) shutdown(connection.file, SHUT_RDWR);
}

ZeroMqSocket::ZeroMqSocket(const Network& network, ZeroMq& zeroMq, zmq::socket_type type,
                           const SocketLimits& limits)
    : Socket{network}, listens_{type == zmq::socket_type::router}, socket_{zeroMq.context(), type} {
  socket_.set(zmq::sockopt::linger, 0);
  socket_.set(zmq::sockopt::sndhwm, limits.frames);
  socket_.set(zmq::sockopt::rcvhwm, limits.frames);
  socket_.set(zmq::sockopt::maxmsgsize, limits.frameSize);
  // A connection whose peer does not acknowledge ends soon: the longer the network was cut, the
  // later TCP would try again. Not by ZeroMQ's heartbeats: when one is due while a full queue is
  // not read and the peer is gone, libzmq 4.3 ends the program (its issue 4364).
  socket_.set(zmq::sockopt::tcp_maxrt, 1500);
  socket_.set(zmq::sockopt::tcp_keepalive, 1);
  socket_.set(zmq::sockopt::tcp_keepalive_idle, 1);
  socket_.set(zmq::sockopt::tcp_keepalive_intvl, 1);
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
  if (endpoint.substr(0, 6) == "tcp://")
    socket->guard_.emplace(zeroMq, socket->socket_, limits, !keys);
  try {
    socket->socket_.bind(endpoint);
  } catch (const zmq::error_t& error) {
    return endpointError(endpoint, error.what());
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
  raw.set(zmq::sockopt::connect_timeout, 500);
  raw.set(zmq::sockopt::reconnect_ivl, 20);
  raw.set(zmq::sockopt::reconnect_ivl_max, 500);
  if (keys) {
    raw.set(zmq::sockopt::curve_serverkey, keys->serverPublic);
    raw.set(zmq::sockopt::curve_publickey, keys->clientPublic);
    raw.set(zmq::sockopt::curve_secretkey, keys->clientSecret);
  }
  socket->handshakes_.emplace(zeroMq, raw,
                              ZMQ_EVENT_HANDSHAKE_SUCCEEDED | ZMQ_EVENT_HANDSHAKE_FAILED_AUTH |
                                  ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL |
                                  ZMQ_EVENT_HANDSHAKE_FAILED_NO_DETAIL);
  try {
    raw.connect(endpoint);
  } catch (const zmq::error_t& error) {
    return endpointError(endpoint, error.what());
  }
  return std::unique_ptr<Socket>{std::move(socket)};
}

std::string ZeroMqSocket::trouble() {
  while (const auto event = handshakes_ ? handshakes_->next() : std::nullopt)
    trouble_ = event->kind == ZMQ_EVENT_HANDSHAKE_SUCCEEDED
                   ? ""
                   : "the key does not fit, or one of both sides has none";
  return trouble_;
}

bool ZeroMqSocket::send(std::string_view peer, FrameKind kind, const Topic& topic,
                        const void* value) {
  const RepresentationType& type = *topic.type;
  const std::size_t size = value ? type.encodedSize(value) : 0;
  zmq::message_t message{Frame::headerSize + size};
  std::ranges::copy(frameHeader(frame(kind, topic)), message.data<std::byte>());
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
  constexpr std::int64_t checkAfter = 5;  // ms
  try {
    if (guard_ && network_.elapsed() - checked_ >= checkAfter) {
      guard_->check();
      checked_ = network_.elapsed();
    }
    return receiveFrame(received);
  } catch (const zmq::error_t&) {
    return false;  // interrupted by a signal
  }
}

bool ZeroMqSocket::receiveFrame(Received& received) {
  constexpr int mostGarbage = 64;  // then others have their turn first
  for (int garbage = 0; garbage < mostGarbage; ++garbage) {
    if (listens_ && !receivePart(peer_)) return false;
    if (!listens_ || peer_.more()) {
      if (!receivePart(message_)) return false;
      bool whole = !message_.more();
      for (zmq::message_t rest; message_.more() && receivePart(rest) && rest.more();) whole = false;
      const bool admitted = !guard_ || guard_->admits(message_.get(ZMQ_SRCFD));
      const auto parsed = parseFrame({message_.data<std::byte>(), message_.size()});
      if (admitted && whole && parsed) {
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
