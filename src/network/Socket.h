#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "base/Enum.h"
#include "framework/Representation.h"
#include "network/Frame.h"

namespace gt {

class Network;

/// A received message. It refers to the socket's memory and is valid until the next one.
struct Received {
  std::string_view peer;     ///< The sender, if several are possible; otherwise empty.
  std::string_view address;  ///< IP address of the sender, if known.
  Frame frame;
};

/// Reasons for refusing or closing a connection.
enum class Refusal { wrongKey, unknownKey, otherUser, noPlace, share, endless, silent };
/// Number of refusals for each reason.
using Refusals = EnumArray<Refusal, std::uint64_t>;
/// Describes a reason in words.
std::string_view describe(Refusal reason);
/// Describes the refusals: "3 refused: 2 sent nothing, 1 ..."; empty if there were none.
std::string describe(const Refusals& refusals);

/// The subject of a frame: the packages of a type for one receiver.
struct Topic {
  Topic(const RepresentationType& t, std::uint32_t number = 0)  // NOLINT: a type is a topic
      : type{&t}, schema{t.schema().id()}, receiver{number} {}

  const RepresentationType* type;
  std::uint32_t schema;    ///< Id of the schema.
  std::uint32_t receiver;  ///< Number among a process's receivers of the type.
};

/// Limits of a socket's resources.
struct SocketLimits {
  int frames = 64;                     ///< Queued frames in each direction, for each peer; further
                                       ///< ones are dropped.
  std::int64_t frameSize = 4'000'000;  ///< Size in bytes; a larger frame ends the connection.
  std::size_t peers = 64;              ///< Greatest number of peers; further ones are refused.
  std::size_t peersOfOne = 32;         ///< Greatest number of peers per IP address, to keep places
                                       ///< for others.
};

/// One end of connections: listens for several peers, or is connected to one. Does not block. Made
/// by Network.
class Socket {
 public:
  virtual ~Socket() = default;
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;

  /// Sends a package, or a frame without content if there is no value. Returns false if the frame
  /// was dropped, because the peer is absent or too slow.
  virtual bool send(std::string_view peer, FrameKind kind, const Topic& topic,
                    const void* value) = 0;
  /// Receives the next frame. Messages that are not frames are counted and skipped.
  virtual bool receive(Received& received) = 0;
  /// The endpoint of a listening socket; for tcp and port 0 with the port that was chosen.
  virtual std::string endpoint() const = 0;
  /// Why no connection was possible, if known; otherwise empty.
  virtual std::string trouble() { return ""; }
  /// Number of received messages that were not frames.
  std::uint64_t rejected() const { return rejected_; }
  /// The refused connections.
  const Refusals& refusals() const { return refusals_; }

  /// The ZeroMQ socket that signals received data; null if a file descriptor signals it.
  virtual void* zeroMq() const { return nullptr; }
  virtual int file() const { return -1; }

 protected:
  explicit Socket(const Network& network) : network_{network} {}
  /// Makes a frame of this program with the present time.
  Frame frame(FrameKind kind, const Topic& topic) const;

  const Network& network_;
  std::uint64_t rejected_ = 0;
  Refusals refusals_;
};

}  // namespace gt
