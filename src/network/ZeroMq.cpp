#include "network/ZeroMq.h"

#include <arpa/inet.h>
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

/// Of who is connected by a socket of TCP; empty if it is gone.
std::string peerAddressOf(int file) {
  sockaddr_storage peer{};
  socklen_t size = sizeof peer;
  if (getpeername(file, reinterpret_cast<sockaddr*>(&peer), &size) != 0) return "";
  char text[INET6_ADDRSTRLEN] = "";
  const auto* v4 = reinterpret_cast<const sockaddr_in*>(&peer);
  const auto* v6 = reinterpret_cast<const sockaddr_in6*>(&peer);
  const void* address = nullptr;
  if (peer.ss_family == AF_INET) address = &v4->sin_addr;
  if (peer.ss_family == AF_INET6) address = &v6->sin6_addr;
  if (!address || !inet_ntop(peer.ss_family, address, text, sizeof text)) return "";
  return text;
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
                                 bool usersOnly, Refusals& refusals)
    : limits_{limits},
      usersOnly_{usersOnly},
      refusals_{refusals},
      events_{zeroMq, watched,
              ZMQ_EVENT_ACCEPTED | ZMQ_EVENT_DISCONNECTED | ZMQ_EVENT_HANDSHAKE_FAILED_AUTH |
                  ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL} {}

void ConnectionGuard::takeEvents() {
  while (const auto event = events_.next()) {
    if (event->kind == ZMQ_EVENT_HANDSHAKE_FAILED_AUTH ||
        event->kind == ZMQ_EVENT_HANDSHAKE_FAILED_PROTOCOL) {
      const bool isUnknown = event->kind == ZMQ_EVENT_HANDSHAKE_FAILED_AUTH;
      ++refusals_[isUnknown ? Refusal::unknownKey : Refusal::wrongKey];
      ++failedHandshakes_;
      continue;
    }
    forget(event->value);
    if (event->kind != ZMQ_EVENT_ACCEPTED) continue;
    if (hasRoom()) {
      connections_.push_back({event->value, peerAddressOf(event->value)});
    } else {
      ++refusals_[Refusal::noPlace];
      shutdown(event->value, SHUT_RDWR);
    }
  }
}

/// A connection has ended. ZeroMQ does not say of which one a handshake has failed.
void ConnectionGuard::forget(int file) {
  const auto ended = std::ranges::find(connections_, file, &Connection::file);
  if (ended == connections_.end()) return;
  if (!ended->known) {
    if (failedHandshakes_ > 0)
      --failedHandshakes_;
    else
      ++refusals_[Refusal::silent];
  }
  connections_.erase(ended);
}

/// Who has sent nothing yet leaves for who comes later.
bool ConnectionGuard::hasRoom() {
  if (connections_.size() < limits_.peers) return true;
  const auto stranger =
      std::ranges::find_if(connections_, [](const Connection& c) { return !c.known; });
  if (stranger == connections_.end()) return false;
  drop(stranger, Refusal::silent);
  return true;
}

void ConnectionGuard::drop(std::vector<Connection>::iterator connection, Refusal reason) {
  ++refusals_[reason];
  shutdown(connection->file, SHUT_RDWR);
  connections_.erase(connection);
}

/// Whether its address has a place left for it.
bool ConnectionGuard::hasShare(const Connection& connection) const {
  const auto others = std::ranges::count_if(connections_, [&](const Connection& other) {
    return other.known && other.address == connection.address;
  });
  return static_cast<std::size_t>(others) < limits_.peersOfOne;
}

bool ConnectionGuard::admits(int connection) {
  takeEvents();
  const auto found = std::ranges::find(connections_, connection, &Connection::file);
  if (found == connections_.end()) return false;
  // Whose it is takes long to find out: not for each of thousands who connect and send nothing.
  if (!found->known && usersOnly_ && !isPeerOfThisUser(connection)) {
    drop(found, Refusal::otherUser);
    return false;
  }
  if (!found->known && !hasShare(*found)) {
    drop(found, Refusal::share);
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
  for (auto connection = connections_.begin(); connection != connections_.end();)
    if (isTolerable(*connection)) {
      ++connection;
    } else {
      ++refusals_[Refusal::endless];
      shutdown(connection->file, SHUT_RDWR);
      connection = connections_.erase(connection);
    }
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
    socket->guard_.emplace(zeroMq, socket->socket_, limits, !keys, socket->refusals_);
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
  socket->hasKey_ = keys.has_value();
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
    trouble_ = event->kind == ZMQ_EVENT_HANDSHAKE_SUCCEEDED ? ""
               : hasKey_ ? "the key does not fit, or the other side has none"
                         : "it asks for a key, and this side has none";
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
      const char* const address = message_.gets("Peer-Address");
      address_ = address ? address : "";
      const bool admitted = !guard_ || guard_->admits(message_.get(ZMQ_SRCFD));
      const auto parsed = parseFrame({message_.data<std::byte>(), message_.size()});
      if (admitted && whole && parsed) {
        received.peer = listens_ ? peer_.to_string_view() : std::string_view{};
        received.address = address_;
        received.frame = *parsed;
        return true;
      }
    }
    ++rejected_;
  }
  return false;
}

}  // namespace gt
