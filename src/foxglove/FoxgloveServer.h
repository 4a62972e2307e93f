#pragma once
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "foxglove/FoxgloveMessages.h"
#include "foxglove/WebSocketServer.h"
#include "observer/ObservedRobot.h"
#include "representations/infrastructure/Image.h"
#include "streams/Json.h"

namespace gt {

struct FoxgloveRequest;
struct FoxgloveSubscription;

/// The endpoint for viewers, and the origins of browser pages that may connect.
struct FoxgloveAccess {
  /// PORT on the loopback device, or ADDRESS:PORT; port 0 is any free one. Empty: none.
  std::string endpoint{};
  /// Origins of pages that may connect, in addition to those from this machine:
  /// SCHEME://HOST[:PORT], or file:// for programs that load their page from the disk.
  std::vector<std::string> origins{};
};

/// The true poses of all objects in a simulation.
struct FoxgloveTruth {
  std::vector<foxglove::TrueBody> robots, balls;
  double ballRadius = 0;  ///< mm
};

/// The robots and data that a FoxgloveServer shows.
struct FoxgloveSubject {
  Time now;
  FieldDimensions field;
  std::vector<ObservedRobot*> robots{};
  std::function<FoxgloveTruth()> truth{};    ///< Empty if nothing is simulated.
  std::function<void()> parameterChanged{};  ///< Called when a client has changed something.
};

/// Shows robots to viewers such as Foxglove and Lichtblick, by the Foxglove WebSocket protocol
/// (docs/foxglove.md): each representation of a robot as it is in logs, images, drawings, plots,
/// texts, frames of reference and parameters. A robot is asked only for what a client has
/// subscribed. One thread calls it, and it never waits for a client.
class FoxgloveServer {
 public:
  /// `name` is shown by viewers. Returns an error if the endpoint or an origin is invalid.
  static Result<std::unique_ptr<FoxgloveServer>> open(const FoxgloveAccess& access,
                                                      std::string name);

  /// Answers clients, and sends what is new to them. Called after each step, and again and again
  /// while time stands. Between two calls the robots of the subject remain, unless `forget` is
  /// called.
  void update(const FoxgloveSubject& subject);
  /// Forgets all robots, because they are about to be destroyed.
  void forget();
  /// Sends a text that concerns the whole match, such as a decision of the referee.
  void log(const std::string& source, const std::string& text, Severity severity = Severity::note);

  std::uint16_t port() const { return server_->port(); }
  /// Number of messages that slow clients did not receive.
  std::uint64_t dropped() const { return server_->dropped() + skipped_; }
  /// Number of messages encoded for clients; each counts once, for any number of clients.
  std::uint64_t encoded() const { return encoded_; }
  std::size_t viewers() const { return clients_.size(); }
  /// The refused connections and their reasons.
  std::vector<WebSocketServer::Refusal> refusals() const { return server_->refusals(); }
  /// The same as lines for the user: of each reason one, once.
  std::vector<std::string> takeNews();

 private:
  using Clock = std::chrono::steady_clock;
  using ClientId = std::uint64_t;

  enum class Source { representation, camera, scene, image, plot, field, truth, transforms, log };
  struct Subscriber {
    ClientId client;
    std::uint32_t subscription;
  };
  using Parameters = std::map<std::string, std::string>;  ///< By their whole names.
  struct Robot;
  struct Channel {
    std::uint32_t id = 0;
    Source source = Source::representation;
    Robot* robot = nullptr;
    std::string name;  ///< Of the representation or debug key.
    std::string topic;
    Schema schema;
    std::vector<Subscriber> subscribers{};
    std::vector<ObservedRobot::Subscription> feeds{};  ///< What robots are asked for.
  };
  /// The drawings of a key at one time that were not sent yet.
  struct Drawn {
    Drawing drawing;
    Time time;
    bool sent = true;
  };
  struct Robot {
    ObservedRobot* observed;
    TeamColor team = TeamColor::red;
    std::map<std::uint32_t, Channel*> representations{};  ///< By message ids.
    std::map<std::string, Channel*, std::less<>> scenes{}, images{}, plots{};
    Channel* camera = nullptr;
    Image image{};  ///< The newest, if it is not sent yet.
    bool imageSent = true;
    Time lastImage = never();
    std::map<std::string, Drawn> drawn{};
    Parameters parameters{};  ///< As they were sent last.
    std::shared_ptr<const void> passing{};
    std::string field() const;
    std::string frame() const { return observed->name(); }
  };
  struct Client {
    std::map<std::uint32_t, Channel*> subscriptions{};
    /// Those that it wants to know when they change: names that there are.
    std::set<std::string> parameters{};
    std::deque<WebSocketServer::Event> requests{};  ///< Not answered yet.
    Clock::time_point pausedUntil{};
  };
  /// When something was sent that changes all the time.
  struct Paced {
    Time time = never();
    Clock::time_point sent{};
  };

  FoxgloveServer(std::unique_ptr<WebSocketServer> server, std::string name);

  void take(WebSocketServer::Event event);
  void greet(ClientId id);
  void serveClients(const FoxgloveSubject& subject);
  void answer(ClientId id, Client& client, const WebSocketServer::Event& event,
              const FoxgloveSubject& subject);
  void perform(ClientId id, Client& client, const FoxgloveRequest& request,
               const FoxgloveSubject& subject);
  void subscribe(ClientId id, Client& client, const std::vector<FoxgloveSubscription>& wanted);
  Result<void> subscribe(ClientId id, Client& client, const FoxgloveSubscription& wanted);
  void unsubscribe(ClientId id, Client& client, std::uint32_t subscription);
  void feed(Channel& channel);

  void addRobots(const FoxgloveSubject& subject);
  bool addChannels(Robot& robot);
  Channel& add(Source source, Robot* robot, std::string name, std::string topic, Schema schema);
  void advertise(const std::vector<const Channel*>& channels, const ClientId* only = nullptr);

  void take(Robot& robot, const Message& message);
  void takeDrawing(Robot& robot, const Message& message);
  void takeImage(Robot& robot, const Message& message);
  void publishNew(const FoxgloveSubject& subject);
  void publishImages();
  void publishDrawings();
  void publishWorld(const FoxgloveSubject& subject);
  foxglove::FrameTransforms framesOf(const FoxgloveSubject& subject,
                                     const FoxgloveTruth& truth) const;
  bool isTaken(const Channel& channel, bool newestOnly) const;
  bool isDue(Paced& paced, const Channel& channel, Time now) const;
  template <typename T>
  void publish(Channel& channel, Time time, const T& message, bool newestOnly);
  void publish(Channel& channel, Time time, std::string bytes, bool newestOnly);

  Parameters parametersOf(Robot& robot);
  Robot* robotOf(std::string_view parameter);
  void sendParameters(ClientId client, const std::vector<std::string>& names,
                      const std::string& answers);
  void sendParameters(ClientId client, Json list, const std::string& answers);
  void setParameters(ClientId client, const FoxgloveRequest& request,
                     const FoxgloveSubject& subject);
  void subscribeParameters(Client& client, const std::vector<std::string>& names);
  void notifyParameters(Robot& robot);
  void followParameters();

  /// Reports the first of several errors, and their number.
  void reportFaults(ClientId client, Severity severity, const std::vector<Error>& faults);
  void sendJson(ClientId client, const Json& json);
  void status(ClientId client, Severity severity, const std::string& text);

  std::unique_ptr<WebSocketServer> server_;
  std::string name_, session_;
  std::map<ClientId, Client> clients_;
  std::vector<std::unique_ptr<Robot>> robots_;
  std::map<std::uint32_t, std::unique_ptr<Channel>> channels_;
  std::uint32_t lastChannel_ = 0;
  Channel *field_ = nullptr, *truth_ = nullptr, *transforms_ = nullptr, *log_ = nullptr;
  Time now_;
  Paced truthPaced_, framesPaced_;
  std::uint64_t encoded_ = 0;
  std::uint64_t skipped_ = 0;       ///< Messages that nobody would have taken.
  std::set<std::string> reported_;  ///< Reasons of refusals.
  Clock::time_point newsAsked_, timeSent_, fieldSent_, robotsSought_, parametersAsked_;
  std::size_t nextToAsk_ = 0;
};

}  // namespace gt
