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
/// 2.2.3.1): each sender serves whoever asks for its package, each receiver asks one process for
/// it. A process that ends is forgotten after a second; one that is started again asks anew.
///
/// A package states by which schema it was written. If that is another one than the receiver's, as
/// the programs were built from different versions, the receiver asks for it and reads the package
/// field by field.
class Wire {
 public:
  /// `name` is what other processes know this one by.
  Wire(Network& network, std::string name);
  ~Wire();

  Result<void> listen(const std::string& endpoint, const std::optional<Keys>& keys = {});
  Result<void> connect(const std::string& peer, const std::string& endpoint,
                       const std::optional<Keys>& keys = {});

  /// Serves this sender's package to every process that asks.
  void provide(PackageSender& sender) { senders_.push_back(&sender); }
  /// Asks a process for the package of this receiver, again and again.
  void receive(const std::string& peer, PackageReceiver& receiver);

  /// Takes what came in. To be called before each cycle of the process.
  void takeIn();
  /// Notifies others of what the receivers are ready for. To be called after each cycle, and when
  /// there was no reason for one.
  void askForMore();

  /// The newest time that a peer stamped its packages with, and the session it is in; 0 as long as
  /// nothing came from it.
  struct Clock {
    Time time;
    std::uint64_t session = 0;
  };
  Clock clockOf(std::string_view peer) const;
  /// Packages and requests that came in and could not be used.
  std::uint64_t rejected() const { return rejected_; }
  /// News about the other programs that was not yet reported to the user, line by line:
  /// who does not answer where he is expected, and whose packages are of another version.
  std::vector<std::string> takeNews() { return std::exchange(news_, {}); }

 private:
  class Link;
  struct Peer {
    std::string name;
    Socket* socket;
    Clock clock;
    std::string endpoint{};  ///< Where it is expected; empty if it came by itself.
    bool missed = false;     ///< That it does not answer was reported.
  };
  /// How a peer writes packages of a type, if otherwise than this program.
  struct Foreign {
    std::uint32_t schema;                           ///< Its id.
    std::optional<MessageDefinition> definition{};  ///< Empty until it is known, or if it is wrong.
    bool known = false;
  };
  struct Inbound {
    std::string peer;
    PackageReceiver* receiver;
    Topic topic;
    std::int64_t asked = -1;  ///< When the peer was asked last; -1 if it has to be asked now.
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
