#pragma once
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "framework/Package.h"
#include "network/Network.h"
#include "streams/MessageDefinition.h"

namespace gt {

/// Connects the senders and receivers of this program's process with those of others (report
/// 2.2.3.1). Each sender serves all processes that request its package; each receiver requests it
/// from one process. A process that ends is forgotten after a second; a restarted process sends its
/// requests again.
///
/// A package states the schema by which it was written. If the receiver has another schema, because
/// the programs were built from different versions, it requests the sender's schema and reads the
/// package field by field.
class Wire {
 public:
  /// `name` is the name by which other processes know this one.
  Wire(Network& network, std::string name);
  ~Wire();

  Result<void> listen(const std::string& endpoint, const std::optional<Keys>& keys = {});
  Result<void> connect(const std::string& peer, const std::string& endpoint,
                       const std::optional<Keys>& keys = {});

  /// Serves this sender's package to every process that requests it.
  void provide(PackageSender& sender) { senders_.push_back(&sender); }
  /// Repeatedly requests the package of this receiver from a process.
  void receive(const std::string& peer, PackageReceiver& receiver);

  /// Receives packages and requests. Must be called before each cycle of the process.
  void takeIn();
  /// Notifies other processes of the packages that the receivers are ready for. Must be called
  /// after each cycle, and when there was no cycle.
  void askForMore();

  /// The newest time stamp of a peer's packages, and the peer's session; 0 before the first
  /// package.
  struct Clock {
    Time time;
    std::uint64_t session = 0;
  };
  Clock clockOf(std::string_view peer) const;
  /// Number of received packages and requests that were invalid.
  std::uint64_t rejected() const { return rejected_; }
  /// News about the other programs that were not yet reported to the user, one per line: expected
  /// programs that do not answer, and programs that send packages of another version.
  std::vector<std::string> takeNews() { return std::exchange(news_, {}); }

 private:
  class Link;
  struct Peer {
    std::string name;
    Socket* socket;
    Clock clock;
    std::string endpoint{};  ///< Expected endpoint; empty if the peer connected by itself.
    bool missed = false;     ///< Whether it was reported that the peer does not answer.
  };
  /// The schema of a peer's packages of a type, if it differs from that of this program.
  struct Foreign {
    std::uint32_t schema;                           ///< Id of the schema.
    std::optional<MessageDefinition> definition{};  ///< Empty until the schema was received, or if
                                                    ///< it is invalid.
    bool known = false;
  };
  struct Inbound {
    std::string peer;
    PackageReceiver* receiver;
    Topic topic;
    std::int64_t asked = -1;  ///< Time of the last request to the peer; -1 if it must be sent now.
    FrameKind sent = FrameKind::package;
    std::optional<Foreign> foreign{};
  };

  Peer* find(std::string_view name);
  Peer* peerFor(Socket& socket, std::string_view name);
  void take(Socket& socket, const Received& received);
  void takeRequest(Peer& peer, const Frame& frame);
  void takePackage(Peer& peer, const Frame& frame);
  Result<void> deliver(Inbound& inbound, Peer& peer, const Frame& frame);
  void describe(Peer& peer, const Frame& frame);
  void takeDescription(const Peer& peer, const Frame& frame);
  PackageSender* senderOf(std::uint32_t type) const;
  Link* linkFor(Peer& peer, const Frame& frame);
  void ask(Inbound& inbound);
  void lookFor(Peer& peer);
  void report(const std::string& line);

  Network& network_;
  std::string name_;
  Socket* listening_ = nullptr;
  std::vector<std::unique_ptr<Peer>> peers_;
  std::vector<PackageSender*> senders_;
  std::vector<std::unique_ptr<Link>> links_;
  std::vector<Inbound> inbound_;
  std::uint64_t rejected_ = 0;
  std::set<std::string> reported_;
  std::vector<std::string> news_;
};

}  // namespace gt
