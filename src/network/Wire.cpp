#include "network/Wire.h"

#include <algorithm>

#include "network/Vocabulary.h"
#include "streams/RecordedMessage.h"

namespace gt {
namespace {

/// Who has not been heard of for so long is not there any more, in ms.
constexpr std::int64_t peerLostAfter = 1000;
/// A request is repeated, in case that it or its answer was lost with a process, in ms.
constexpr std::int64_t requestRepeatedAfter = 100;
/// Who has not answered for so long is waited for in vain, in ms.
constexpr std::int64_t missedAfter = 3000;
/// A robot has less processes, and none of them more receivers of one type.
constexpr std::size_t mostPeers = 64;
constexpr std::uint32_t mostReceivers = 16;
/// What is taken in one go, so that a flood does not hold the process up.
constexpr int peerFramesPerUpdate = 256;
/// More is not reported to the user.
constexpr std::size_t mostNews = 100;

}  // namespace

/// The sender's view of a receiver in another program.
class Wire::Link : public PackageLink {
 public:
  Link(Network& network, Peer& peer, const Topic& topic)
      : network_{network}, peer_{peer}, topic_{topic} {}

  bool active() const override { return network_.elapsed() - heard_ < peerLostAfter; }
  bool requested() const override { return requested_ && active(); }
  bool accepts() const override { return accepts_ && active(); }
  void deliver(const void* package) override {
    peer_.socket->send(peer_.name, FrameKind::package, topic_, package);
    requested_ = accepts_ = false;
  }
  void hear(FrameKind kind) {
    heard_ = network_.elapsed();
    accepts_ = true;
    requested_ = kind == FrameKind::request;
  }
  bool connects(const Peer& peer, const Frame& frame) const {
    return &peer == &peer_ && frame.type == topic_.type->id && frame.receiver == topic_.receiver;
  }

 private:
  Network& network_;
  Peer& peer_;
  Topic topic_;
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
  peers_.push_back(std::make_unique<Peer>(Peer{peer, *socket, {}, endpoint}));
  return {};
}

void Wire::receive(const std::string& peer, PackageReceiver& receiver) {
  const auto number = std::ranges::count_if(inbound_, [&](const Inbound& other) {
    return other.peer == peer && other.topic.type == &receiver.type();
  });
  inbound_.push_back({peer, &receiver, {receiver.type(), static_cast<std::uint32_t>(number)}});
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
    for (int i = 0; i < peerFramesPerUpdate && socket.receive(received); ++i)
      take(socket, received);
  };
  if (listening_) takeAll(*listening_);
  for (std::size_t i = 0; i < peers_.size(); ++i)
    if (peers_[i]->socket != listening_) takeAll(*peers_[i]->socket);
}

void Wire::askForMore() {
  for (Inbound& inbound : inbound_) ask(inbound);
  for (const auto& peer : peers_)
    if (!peer->endpoint.empty()) lookFor(*peer);
}

/// Reports once that a program does not answer, and again when it does.
void Wire::lookFor(Peer& peer) {
  const bool there = peer.clock.session != 0;
  if (there == !peer.missed || (!there && network_.elapsed() < missedAfter)) return;
  peer.missed = !there;
  if (there) return news_.push_back("'" + peer.name + "' answers now");
  const std::string trouble = peer.socket->trouble();
  news_.push_back("'" + peer.name + "' does not answer at " + peer.endpoint +
                  (trouble.empty() ? "" : ": " + trouble));
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
  if (frame.kind == FrameKind::describe) return describe(peer, frame);
  if (Link* link = linkFor(peer, frame))
    link->hear(frame.kind);
  else
    ++rejected_;
}

PackageSender* Wire::senderOf(std::uint32_t type) const {
  const auto sender = std::ranges::find_if(
      senders_, [&](const PackageSender* candidate) { return candidate->type().id == type; });
  return sender == senders_.end() ? nullptr : *sender;
}

Wire::Link* Wire::linkFor(Peer& peer, const Frame& frame) {
  for (const auto& link : links_)
    if (link->connects(peer, frame)) return link.get();
  PackageSender* sender = senderOf(frame.type);
  if (!sender || frame.receiver >= mostReceivers) return nullptr;
  links_.push_back(std::make_unique<Link>(network_, peer, Topic{sender->type(), frame.receiver}));
  sender->connect(*links_.back());
  return links_.back().get();
}

void Wire::describe(Peer& peer, const Frame& frame) {
  const PackageSender* sender = senderOf(frame.type);
  if (!sender) return;
  const TypeDescription description = TypeDescription::of(sender->type());
  peer.socket->send(peer.name, FrameKind::package, representation<TypeDescription>(), &description);
}

void Wire::takeDescription(const Peer& peer, const Frame& frame) {
  TypeDescription description;
  if (!decode(frame.bytes, description)) {
    ++rejected_;
    return;
  }
  for (Inbound& inbound : inbound_) {
    if (!inbound.foreign || inbound.peer != peer.name ||
        inbound.topic.type->id != description.type ||
        inbound.foreign->schema != Schema{description.name, description.schema}.id())
      continue;
    const std::string what = "'" + peer.name + "' was built from another version: its " +
                             std::string{inbound.topic.type->name};
    inbound.foreign->known = true;
    auto definition = MessageDefinition::parse(description.name, description.schema);
    if (definition && inbound.topic.type->type()) {
      inbound.foreign->definition = std::move(*definition);
      report(what + " is read field by field");
    } else {
      report(what + " cannot be read: " +
             (definition ? "it is not made of fields" : definition.error().text()));
    }
  }
}

void Wire::report(const std::string& line) {
  if (reported_.size() < mostNews && reported_.insert(line).second) news_.push_back(line);
}

void Wire::takePackage(Peer& peer, const Frame& frame) {
  if (frame.session != peer.clock.session || frame.time > peer.clock.time)
    peer.clock = {frame.time, frame.session};
  if (frame.type == representation<TypeDescription>().id) return takeDescription(peer, frame);
  const auto inbound = std::ranges::find_if(inbound_, [&](const Inbound& candidate) {
    return candidate.topic.type->id == frame.type && candidate.peer == peer.name &&
           candidate.topic.receiver == frame.receiver;
  });
  if (inbound == inbound_.end()) {
    ++rejected_;
    return;
  }
  inbound->asked = -1;
  if (const auto done = deliver(*inbound, peer, frame); !done) {
    ++rejected_;
    report("'" + peer.name + "' sends a " + std::string{inbound->topic.type->name} +
           " that cannot be read: " + done.error().text());
  }
}

/// A package of another version is read into a value that holds what the type begins with.
Result<void> Wire::deliver(Inbound& inbound, Peer& peer, const Frame& frame) {
  PackageReceiver& receiver = *inbound.receiver;
  if (frame.schema == inbound.topic.schema) return receiver.deliverBytes(frame.bytes);
  if (!inbound.foreign || inbound.foreign->schema != frame.schema)
    inbound.foreign = Foreign{frame.schema};
  if (!inbound.foreign->known)
    peer.socket->send(peer.name, FrameKind::describe, inbound.topic, nullptr);
  if (!inbound.foreign->definition) return {};
  const std::shared_ptr<void> value = inbound.topic.type->make();
  auto done = readRecorded(*inbound.foreign->definition, frame.bytes,
                           {inbound.topic.type->type(), value.get()});
  if (done) receiver.deliver(value.get());
  return done;
}

void Wire::ask(Inbound& inbound) {
  if (!inbound.receiver->accepts()) return;
  const FrameKind kind = inbound.receiver->requested() ? FrameKind::request : FrameKind::accept;
  const bool known = inbound.asked >= 0 && inbound.sent == kind &&
                     network_.elapsed() - inbound.asked < requestRepeatedAfter;
  if (known) return;
  Peer* peer = find(inbound.peer);
  if (!peer) return;
  peer->socket->send(peer->name, kind, inbound.topic, nullptr);
  inbound.asked = network_.elapsed();
  inbound.sent = kind;
}

}  // namespace gt
