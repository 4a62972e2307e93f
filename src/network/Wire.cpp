#include "network/Wire.h"

#include <algorithm>

namespace gt {
namespace {

/// Who has not been heard of for so long is not there any more, in ms.
constexpr std::int64_t lostAfter = 1000;
/// A request is repeated, in case that it or its answer was lost with a process, in ms.
constexpr std::int64_t repeatAfter = 100;
/// A robot has less processes.
constexpr std::size_t mostPeers = 64;
/// What is taken in one go, so that a flood does not hold the process up.
constexpr int framesPerUpdate = 256;

}  // namespace

/// The sender's view of a receiver in another program.
class Wire::Link : public PackageLink {
 public:
  Link(Network& network, Peer& peer, const RepresentationType& type)
      : network_{network}, peer_{peer}, type_{type} {}

  bool active() const override { return network_.elapsed() - heard_ < lostAfter; }
  bool requested() const override { return requested_ && active(); }
  bool accepts() const override { return accepts_ && active(); }
  void deliver(const void* package) override {
    peer_.socket->send(peer_.name, FrameKind::package, type_, package);
    requested_ = accepts_ = false;
  }
  void hear(FrameKind kind) {
    heard_ = network_.elapsed();
    accepts_ = true;
    requested_ = kind == FrameKind::request;
  }
  bool connects(const Peer& peer, std::uint32_t type) const {
    return &peer == &peer_ && type == type_.id;
  }

 private:
  Network& network_;
  Peer& peer_;
  const RepresentationType& type_;
  std::int64_t heard_ = 0;
  bool requested_ = false;
  bool accepts_ = false;
};

Wire::Wire(Network& network, std::string name) : network_{network}, name_{std::move(name)} {}

Wire::~Wire() = default;

Result<void> Wire::listen(const std::string& endpoint, const std::optional<Keys>& keys) {
  const auto socket = network_.listen(endpoint, keys);
  if (!socket) return socket.error();
  listening_ = *socket;
  return {};
}

Result<void> Wire::connect(const std::string& peer, const std::string& endpoint,
                           const std::optional<Keys>& keys) {
  const auto socket = network_.connect(endpoint, name_, keys);
  if (!socket) return socket.error();
  peers_.push_back(std::make_unique<Peer>(Peer{peer, *socket, {}}));
  return {};
}

void Wire::receive(const std::string& peer, PackageReceiver& receiver) {
  inbound_.push_back({peer, &receiver});
}

Wire::Peer* Wire::find(std::string_view name) {
  const auto peer =
      std::ranges::find_if(peers_, [&](const auto& candidate) { return candidate->name == name; });
  return peer == peers_.end() ? nullptr : peer->get();
}

Wire::Peer* Wire::peerFor(Socket& socket, std::string_view name) {
  if (&socket != listening_)
    return std::ranges::find_if(peers_, [&](const auto& p) { return p->socket == &socket; })->get();
  if (Peer* peer = find(name)) return peer->socket == listening_ ? peer : nullptr;
  if (peers_.size() >= mostPeers) return nullptr;
  return peers_.emplace_back(std::make_unique<Peer>(Peer{std::string{name}, &socket, {}})).get();
}

Wire::Clock Wire::clockOf(std::string_view name) const {
  const Peer* peer = const_cast<Wire*>(this)->find(name);
  return peer ? peer->clock : Clock{};
}

void Wire::takeIn() {
  Received received;
  const auto takeAll = [&](Socket& socket) {
    for (int i = 0; i < framesPerUpdate && socket.receive(received); ++i) take(socket, received);
  };
  if (listening_) takeAll(*listening_);
  for (std::size_t i = 0; i < peers_.size(); ++i)
    if (peers_[i]->socket != listening_) takeAll(*peers_[i]->socket);
}

void Wire::askForMore() {
  for (Inbound& inbound : inbound_) ask(inbound);
}

void Wire::take(Socket& socket, const Received& received) {
  Peer* peer = peerFor(socket, received.peer);
  if (!peer) {
    ++rejected_;
    return;
  }
  if (received.frame.kind == FrameKind::package)
    takePackage(*peer, received.frame);
  else
    takeRequest(*peer, received.frame);
}

void Wire::takeRequest(Peer& peer, const Frame& frame) {
  if (frame.session != peer.clock.session) peer.clock = {frame.time, frame.session};
  if (Link* link = linkFor(peer, frame.type))
    link->hear(frame.kind);
  else
    ++rejected_;
}

Wire::Link* Wire::linkFor(Peer& peer, std::uint32_t type) {
  for (const auto& link : links_)
    if (link->connects(peer, type)) return link.get();
  for (PackageSender* sender : senders_)
    if (sender->type().id == type) {
      links_.push_back(std::make_unique<Link>(network_, peer, sender->type()));
      sender->connect(*links_.back());
      return links_.back().get();
    }
  return nullptr;
}

void Wire::takePackage(Peer& peer, const Frame& frame) {
  if (frame.session != peer.clock.session || frame.time > peer.clock.time)
    peer.clock = {frame.time, frame.session};
  for (Inbound& inbound : inbound_)
    if (inbound.receiver->type().id == frame.type && inbound.peer == peer.name) {
      inbound.asked = -1;
      if (!inbound.receiver->deliverBytes(frame.bytes)) ++rejected_;
      return;
    }
  ++rejected_;
}

void Wire::ask(Inbound& inbound) {
  if (!inbound.receiver->accepts()) return;
  const FrameKind kind = inbound.receiver->requested() ? FrameKind::request : FrameKind::accept;
  const bool known = inbound.asked >= 0 && inbound.told == kind &&
                     network_.elapsed() - inbound.asked < repeatAfter;
  if (known) return;
  Peer* peer = find(inbound.peer);
  if (!peer) return;
  peer->socket->send(peer->name, kind, inbound.receiver->type(), nullptr);
  inbound.asked = network_.elapsed();
  inbound.told = kind;
}

}  // namespace gt
