#include "foxglove/FoxgloveServer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "logs/MessageTypes.h"
#include "logs/RobotLog.h"
#include "network/Endpoint.h"
#include "representations/infrastructure/Image.h"
#include "representations/modeling/RobotPose.h"

namespace gt {
namespace {

using std::chrono::milliseconds;

/// Both are the same protocol; newer viewers offer the second name.
const std::vector<std::string> subprotocols{"foxglove.websocket.v1", "foxglove.sdk.v1"};
const std::string fieldFrame = "field", blueFieldFrame = "field/blue";

/// How often is sent what changes all the time, at most; and what does not.
constexpr milliseconds worldInterval{30}, timeInterval{20}, fieldInterval{1000};
/// How often robots are asked that have not answered.
constexpr milliseconds seekInterval{1000};

// Opcodes of the protocol's binary messages.
constexpr char messageData = 1, timeData = 2;

/// Of two messages of a subscription the older one is replaced while it waits; 0 means neither.
std::uint32_t placeOf(std::uint32_t subscription) {
  return subscription + 1;
}

/// A number in the protocol's byte order.
void append(std::string& text, std::uint64_t number, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) text += static_cast<char>(number >> (8 * i));
}

std::uint64_t nanosecondsOf(Time time) {
  constexpr std::uint64_t perMs = 1'000'000;
  return static_cast<std::uint64_t>(std::max<std::int64_t>(time.ms, 0)) * perMs;
}

Pose3D spatial(const Pose2D& pose) {
  Pose3D result;
  result.rotation = Eigen::AngleAxisd{pose.rotation, Vector3d::UnitZ()}.toRotationMatrix();
  result.translation = {pose.translation.x(), pose.translation.y(), 0};
  return result;
}

std::uint8_t levelOf(Severity severity) {
  switch (severity) {
    case Severity::note:
      return foxglove::Log::info;
    case Severity::warning:
      return foxglove::Log::warning;
    case Severity::error:
      break;
  }
  return foxglove::Log::error;
}

/// Whether a browser could name a page's origin like this (RFC 6454): no path, no slash at the end.
bool isOrigin(std::string_view text) {
  const std::size_t scheme = text.find("://");
  if (scheme == text.npos || scheme == 0) return false;
  const std::string_view host = text.substr(scheme + 3);
  if (host.empty()) return text == "file://";
  return host.find_first_of("/ ?#@") == host.npos;
}

Result<WebSocketServer::Options> optionsOf(const FoxgloveAccess& access) {
  for (const std::string& origin : access.origins)
    if (!isOrigin(origin))
      return Error{.field = origin, .what = "expected an origin, SCHEME://HOST[:PORT] or file://"};
  const auto endpoint = parseEndpoint(access.endpoint);
  if (!endpoint) return endpoint.error();
  return WebSocketServer::Options{.address = endpoint->address,
                                  .port = endpoint->port,
                                  .subprotocols = subprotocols,
                                  .origins = access.origins};
}

}  // namespace

std::string FoxgloveServer::Robot::field() const {
  return team == TeamColor::red ? fieldFrame : blueFieldFrame;
}

FoxgloveServer::FoxgloveServer(std::unique_ptr<WebSocketServer> server, std::string name)
    : server_{std::move(server)},
      name_{std::move(name)},
      session_{std::to_string(std::chrono::system_clock::now().time_since_epoch().count())} {
  field_ = &add(Source::field, nullptr, "", "/field", foxglove::SceneUpdate::schema());
  truth_ = &add(Source::truth, nullptr, "", "/truth", foxglove::SceneUpdate::schema());
  transforms_ = &add(Source::transforms, nullptr, "", "/tf", foxglove::FrameTransforms::schema());
  log_ = &add(Source::log, nullptr, "", "/log", foxglove::Log::schema());
}

Result<std::unique_ptr<FoxgloveServer>> FoxgloveServer::open(const FoxgloveAccess& access,
                                                             std::string name) {
  const auto options = optionsOf(access);
  if (!options) return options.error();
  auto server = WebSocketServer::open(*options);
  if (!server) return server.error();
  return std::unique_ptr<FoxgloveServer>{new FoxgloveServer{std::move(*server), std::move(name)}};
}

void FoxgloveServer::update(const FoxgloveSubject& subject) {
  now_ = subject.now;
  for (auto& event : server_->take()) take(std::move(event));
  serveClients(subject);
  if (clients_.empty()) return;
  addRobots(subject);
  publishNew(subject);
  followParameters();
}

/// Has robots send what a channel shows.
void FoxgloveServer::feed(Channel& channel) {
  const std::string pose{representation<RobotPose>().name};
  const auto ask = [&](const std::string& representation) {
    channel.feeds.push_back(channel.robot->observed->subscribe(representation));
  };
  switch (channel.source) {
    case Source::representation:
      return ask(channel.name);
    case Source::camera:
      return ask(std::string{representation<Image>().name});
    case Source::scene:
    case Source::image:
    case Source::plot:
      channel.feeds.push_back(channel.robot->observed->subscribeKey(channel.name));
      return;
    case Source::transforms:
      for (const auto& robot : robots_) channel.feeds.push_back(robot->observed->subscribe(pose));
      return;
    case Source::field:
    case Source::truth:
    case Source::log:
      return;
  }
}

// Robots and channels.

void FoxgloveServer::addRobots(const FoxgloveSubject& subject) {
  if (robots_.size() == subject.robots.size()) return;
  const auto now = Clock::now();
  if (now < robotsSought_ + seekInterval) return;
  robotsSought_ = now;
  for (ObservedRobot* observed : subject.robots) {
    const bool known = std::ranges::any_of(
        robots_, [&](const auto& robot) { return robot->observed == observed; });
    if (known) continue;
    auto robot = std::make_unique<Robot>(Robot{.observed = observed});
    if (addChannels(*robot)) robots_.push_back(std::move(robot));
  }
}

/// False if the robot does not answer yet.
bool FoxgloveServer::addChannels(Robot& robot) {
  ObservedRobot& observed = *robot.observed;
  if (observed.representations().empty()) return false;
  if (const auto player = observed.value<Player>()) robot.team = (*player)->teamColor;
  const std::uint32_t before = lastChannel_;
  const std::string folder = "/" + observed.name() + "/";
  for (const std::string& name : observed.representations()) {
    const RepresentationType* type = messageType(name);
    if (!type || !type->type()) continue;
    if (type == &representation<Image>())
      robot.camera =
          &add(Source::camera, &robot, name, folder + "camera", CompressedImage::schema());
    else
      robot.representations[type->id] =
          &add(Source::representation, &robot, name, folder + name, type->schema());
  }
  for (const std::string& key : observed.debugKeys()) {
    robot.scenes[key] = &add(Source::scene, &robot, key, folder + "drawings/" + key,
                             foxglove::SceneUpdate::schema());
    robot.images[key] = &add(Source::image, &robot, key, folder + "camera/drawings/" + key,
                             foxglove::ImageAnnotations::schema());
    robot.plots[key] =
        &add(Source::plot, &robot, key, folder + "plots/" + key, representation<Plot>().schema());
  }
  robot.passing = observed.passTo([this, &robot](const MessageQueue& messages) {
    messages.handleAllMessages([&](const Message& message) { take(robot, message); });
  });
  if (!transforms_->subscribers.empty())
    transforms_->feeds.push_back(observed.subscribe(std::string{representation<RobotPose>().name}));
  std::vector<const Channel*> added;
  for (auto i = channels_.upper_bound(before); i != channels_.end(); ++i)
    added.push_back(i->second.get());
  advertise(added);
  return true;
}

FoxgloveServer::Channel& FoxgloveServer::add(Source source, Robot* robot, std::string name,
                                             std::string topic, Schema schema) {
  const std::uint32_t id = ++lastChannel_;
  auto channel = std::make_unique<Channel>(Channel{.id = id,
                                                   .source = source,
                                                   .robot = robot,
                                                   .name = std::move(name),
                                                   .topic = std::move(topic),
                                                   .schema = std::move(schema)});
  return *channels_.emplace(id, std::move(channel)).first->second;
}

void FoxgloveServer::advertise(const std::vector<const Channel*>& channels, const ClientId* only) {
  Json list = Json::array();
  for (const Channel* channel : channels)
    list.push_back({{"id", channel->id},
                    {"topic", channel->topic},
                    {"encoding", "cdr"},
                    {"schemaName", channel->schema.name},
                    {"schema", channel->schema.text},
                    {"schemaEncoding", "ros2msg"}});
  const Json message{{"op", "advertise"}, {"channels", std::move(list)}};
  if (only) return sendJson(*only, message);
  for (const auto& [id, client] : clients_) sendJson(id, message);
}

void FoxgloveServer::forget() {
  Json ids = Json::array();
  const auto belongsToRobot = [&](const auto& entry) { return entry.second->robot != nullptr; };
  for (const auto& entry : channels_)
    if (belongsToRobot(entry)) ids.push_back(entry.first);
  for (auto& [id, client] : clients_) {
    if (!ids.empty()) sendJson(id, {{"op", "unadvertise"}, {"channelIds", ids}});
    std::erase_if(client.subscriptions,
                  [](const auto& entry) { return entry.second->robot != nullptr; });
  }
  transforms_->feeds.clear();
  std::erase_if(channels_, belongsToRobot);
  robots_.clear();
  robotsSought_ = {};
  truthPaced_ = framesPaced_ = {};
}

// What robots send.

void FoxgloveServer::take(Robot& robot, const Message& message) {
  if (clients_.empty()) return;
  if (message.is<Drawing>()) return takeDrawing(robot, message);
  if (message.is<Image>()) return takeImage(robot, message);
  if (message.is<Text>()) {
    Text text;
    if (message.read(text)) log(robot.observed->name(), text.text, text.severity);
    return;
  }
  Plot plot;
  if (message.is<Plot>()) {
    if (!message.read(plot)) return;
  } else if (StopwatchTime lap; message.is<StopwatchTime>()) {
    if (!message.read(lap)) return;
    plot = {lap.event, lap.microseconds};
  } else {
    const auto channel = robot.representations.find(message.id);
    if (channel == robot.representations.end() || channel->second->subscribers.empty()) return;
    if (!isTaken(*channel->second, false)) {
      ++skipped_;
      return;
    }
    const auto* bytes = reinterpret_cast<const char*>(message.bytes.data());
    return publish(*channel->second, message.time, {bytes, message.bytes.size()}, false);
  }
  if (const auto channel = robot.plots.find(plot.key); channel != robot.plots.end())
    publish(*channel->second, message.time, plot, false);
}

/// Several modules may draw under a key at one time (report E.5).
void FoxgloveServer::takeDrawing(Robot& robot, const Message& message) {
  Drawing drawing;
  if (!message.read(drawing)) return;
  const auto& channels = drawing.space == DrawingSpace::image ? robot.images : robot.scenes;
  const auto channel = channels.find(drawing.key);
  if (channel == channels.end() || channel->second->subscribers.empty()) return;
  Drawn& drawn = robot.drawn[channel->second->topic];
  skipped_ += !drawn.sent && drawn.time != message.time;
  if (drawn.time == message.time && drawn.drawing.space == drawing.space)
    std::ranges::move(drawing.elements, std::back_inserter(drawn.drawing.elements));
  else
    drawn.drawing = std::move(drawing);
  drawn.time = message.time;
  drawn.sent = false;
}

/// An image may be sent again while there is no newer one.
void FoxgloveServer::takeImage(Robot& robot, const Message& message) {
  if (!robot.camera || robot.camera->subscribers.empty()) return;
  const bool waits = !std::exchange(robot.imageSent, true);
  if (!message.read(robot.image) || robot.image.pixels.empty()) return;
  const bool isNew = std::exchange(robot.lastImage, robot.image.time) != robot.image.time;
  skipped_ += isNew && waits;
  robot.imageSent = !isNew && !waits;
}

void FoxgloveServer::publishNew(const FoxgloveSubject& subject) {
  publishImages();
  publishDrawings();
  publishWorld(subject);
  const auto now = Clock::now();
  if (now < timeSent_ + timeInterval) return;
  timeSent_ = now;
  constexpr std::uint32_t newestTime = 0xffffffff;
  WebSocketMessage message{.binary = true,
                           .head = {timeData},
                           .body = std::make_shared<const std::string>(),
                           .newestOf = newestTime};
  append(message.head, nanosecondsOf(subject.now), sizeof(std::uint64_t));
  for (const auto& [id, client] : clients_) server_->send(id, message);
}

/// Whether somebody takes a message of the channel now. What is the newest waits until then.
bool FoxgloveServer::isTaken(const Channel& channel, bool newestOnly) const {
  return std::ranges::any_of(channel.subscribers, [&](const Subscriber& subscriber) {
    return server_->takes(subscriber.client, newestOnly ? placeOf(subscriber.subscription) : 0);
  });
}

void FoxgloveServer::publishImages() {
  for (const auto& robot : robots_) {
    if (robot->imageSent) continue;
    robot->imageSent = robot->camera->subscribers.empty();
    if (!isTaken(*robot->camera, true)) continue;
    robot->imageSent = true;
    CompressedImage picture = compressed(robot->image);
    picture.header.frameId = robot->frame() + "/camera";
    publish(*robot->camera, robot->image.time, picture, true);
  }
}

void FoxgloveServer::publishDrawings() {
  for (const auto& robot : robots_)
    for (auto& [topic, drawn] : robot->drawn) {
      if (drawn.sent) continue;
      const Drawing& drawing = drawn.drawing;
      const bool onImage = drawing.space == DrawingSpace::image;
      Channel& channel = *(onImage ? robot->images : robot->scenes).at(drawing.key);
      drawn.sent = channel.subscribers.empty();
      if (!isTaken(channel, true)) continue;
      drawn.sent = true;
      if (onImage) {
        publish(channel, drawn.time, foxglove::imageAnnotations(drawing, drawn.time), true);
      } else {
        const bool onField = drawing.space == DrawingSpace::field;
        publish(channel, drawn.time,
                foxglove::SceneUpdate{{foxglove::sceneEntity(
                    drawing, drawn.time, onField ? robot->field() : robot->frame())}},
                true);
      }
    }
}

/// Whether it is time to send what changes all the time; notes that it is sent.
bool FoxgloveServer::isDue(Paced& paced, const Channel& channel, Time now) const {
  const auto clock = Clock::now();
  if (paced.time == now || clock < paced.sent + worldInterval || !isTaken(channel, true))
    return false;
  paced = {now, clock};
  return true;
}

void FoxgloveServer::publishWorld(const FoxgloveSubject& subject) {
  const auto now = Clock::now();
  if (now >= fieldSent_ + fieldInterval && isTaken(*field_, true)) {
    fieldSent_ = now;
    publish(*field_, subject.now,
            foxglove::SceneUpdate{{foxglove::fieldEntity(subject.field, subject.now, fieldFrame)}},
            true);
  }
  const bool sendsTruth = isDue(truthPaced_, *truth_, subject.now),
             sendsFrames = isDue(framesPaced_, *transforms_, subject.now);
  if (!sendsTruth && !sendsFrames) return;
  const FoxgloveTruth truth = subject.truth ? subject.truth() : FoxgloveTruth{};
  if (sendsTruth) {
    foxglove::SceneUpdate scene;
    for (const foxglove::TrueBody& robot : truth.robots)
      scene.entities.push_back(foxglove::robotEntity(robot, subject.now, fieldFrame));
    for (const foxglove::TrueBody& ball : truth.balls)
      scene.entities.push_back(
          foxglove::ballEntity(ball, truth.ballRadius, subject.now, fieldFrame));
    publish(*truth_, subject.now, scene, true);
  }
  if (sendsFrames) publish(*transforms_, subject.now, framesOf(subject, truth), true);
}

foxglove::FrameTransforms FoxgloveServer::framesOf(const FoxgloveSubject& subject,
                                                   const FoxgloveTruth& truth) const {
  foxglove::FrameTransforms frames;
  const auto add = [&](const std::string& parent, std::string child, const Pose3D& pose) {
    frames.transforms.push_back(foxglove::transformOf(subject.now, parent, std::move(child), pose));
  };
  add(fieldFrame, blueFieldFrame, spatial({pi, Vector2d::Zero()}));
  for (const foxglove::TrueBody& robot : truth.robots)
    add(fieldFrame, robot.name + "/truth", robot.pose);
  for (const auto& robot : robots_)
    if (const RobotPose* believed = robot->observed->newest<RobotPose>())
      add(robot->field(), robot->frame(), spatial(believed->pose));
  return frames;
}

void FoxgloveServer::log(const std::string& source, const std::string& text, Severity severity) {
  if (log_->subscribers.empty()) return;
  publish(*log_, now_,
          foxglove::Log{.timestamp = RosTime::of(now_),
                        .level = levelOf(severity),
                        .message = text,
                        .name = source},
          false);
}

template <typename T>
void FoxgloveServer::publish(Channel& channel, Time time, const T& message, bool newestOnly) {
  if (channel.subscribers.empty()) return;
  if (!newestOnly && !isTaken(channel, false)) {
    ++skipped_;
    return;
  }
  std::string bytes(encodedSize(message), '\0');
  encodeTo(message, reinterpret_cast<std::byte*>(bytes.data()));
  publish(channel, time, std::move(bytes), newestOnly);
}

void FoxgloveServer::publish(Channel& channel, Time time, std::string bytes, bool newestOnly) {
  ++encoded_;
  const auto body = std::make_shared<const std::string>(std::move(bytes));
  for (const auto& [client, subscription] : channel.subscribers) {
    WebSocketMessage message{.binary = true,
                             .head = {messageData},
                             .body = body,
                             .newestOf = newestOnly ? placeOf(subscription) : 0};
    append(message.head, subscription, sizeof subscription);
    append(message.head, nanosecondsOf(time), sizeof(std::uint64_t));
    server_->send(client, std::move(message));
  }
}

}  // namespace gt
