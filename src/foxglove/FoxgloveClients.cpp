// What a FoxgloveServer does with clients and their requests.
#include <algorithm>
#include <utility>

#include "foxglove/FoxgloveRequest.h"
#include "foxglove/FoxgloveServer.h"

namespace gt {
namespace {

using std::chrono::milliseconds;

/// Subscriptions of a client for one channel: each gets every message. A viewer has one.
constexpr std::ptrdiff_t mostSubscriptions = 4;
/// Requests of a client are answered for so long at a time, one at least; then it waits for so many
/// times what that took: neither the program nor other clients wait for it.
constexpr milliseconds requestTime{2};
constexpr int requestPause = 9;
/// How often is looked who was not let in.
constexpr milliseconds newsInterval{1000};

}  // namespace

void FoxgloveServer::take(WebSocketServer::Event event) {
  using Kind = WebSocketServer::EventKind;
  const auto found = clients_.find(event.client);
  if (found != clients_.end() && (event.kind == Kind::text || event.kind == Kind::binary)) {
    found->second.requests.push_back(std::move(event));
    return;
  }
  if (event.kind == Kind::connected) {
    greet(event.client);
  } else if (event.kind == Kind::closed && found != clients_.end()) {
    while (!found->second.subscriptions.empty())
      unsubscribe(event.client, found->second, found->second.subscriptions.begin()->first);
    for (const auto& request : found->second.requests) server_->finish(request);
    clients_.erase(found);
  }
  server_->finish(event);
}

void FoxgloveServer::greet(ClientId id) {
  clients_[id];
  sendJson(id, {{"op", "serverInfo"},
                {"name", name_},
                {"capabilities", {"time", "parameters", "parametersSubscribe"}},
                {"sessionId", session_}});
  std::vector<const Channel*> all;
  for (const auto& [number, channel] : channels_) all.push_back(channel.get());
  advertise(all, &id);
}

void FoxgloveServer::serveClients(const FoxgloveSubject& subject) {
  for (auto& [id, client] : clients_) {
    const auto begin = Clock::now();
    if (client.requests.empty() || begin < client.pausedUntil) continue;
    auto end = begin;
    while (!client.requests.empty() && end - begin < requestTime) {
      answer(id, client, client.requests.front(), subject);
      server_->finish(client.requests.front());
      client.requests.pop_front();
      end = Clock::now();
    }
    client.pausedUntil = end + requestPause * (end - begin);
  }
}

void FoxgloveServer::answer(ClientId id, Client& client, const WebSocketServer::Event& event,
                            const FoxgloveSubject& subject) {
  if (event.kind == WebSocketServer::EventKind::binary)
    status(id, Severity::error, "this server takes no messages");
  else if (const auto request = parseFoxgloveRequest(event.data); !request)
    status(id, Severity::error, request.error().text());
  else
    perform(id, client, *request, subject);
}

void FoxgloveServer::perform(ClientId id, Client& client, const FoxgloveRequest& request,
                             const FoxgloveSubject& subject) {
  using Kind = FoxgloveRequest::Kind;
  switch (request.kind) {
    case Kind::subscribe:
      subscribe(id, client, request.subscriptions);
      break;
    case Kind::unsubscribe:
      for (const std::uint32_t subscription : request.ids) unsubscribe(id, client, subscription);
      break;
    case Kind::getParameters:
      sendParameters(id, request.names, request.id);
      break;
    case Kind::setParameters:
      setParameters(id, request, subject);
      break;
    case Kind::subscribeParameters:
      subscribeParameters(client, request.names);
      break;
    case Kind::unsubscribeParameters:
      if (request.names.empty()) client.parameters.clear();
      for (const std::string& name : request.names) client.parameters.erase(name);
      break;
  }
}

void FoxgloveServer::subscribe(ClientId id, Client& client,
                               const std::vector<FoxgloveSubscription>& wanted) {
  std::vector<Error> faults;
  for (const auto& subscription : wanted)
    if (const auto done = subscribe(id, client, subscription); !done)
      faults.push_back(done.error());
  reportFaults(id, Severity::warning, faults);
}

Result<void> FoxgloveServer::subscribe(ClientId id, Client& client,
                                       const FoxgloveSubscription& wanted) {
  const auto found = channels_.find(wanted.channel);
  if (found == channels_.end())
    return Error{.what = "there is no channel " + std::to_string(wanted.channel)};
  Channel& channel = *found->second;
  if (client.subscriptions.contains(wanted.id))
    return Error{.what = "there is already a subscription " + std::to_string(wanted.id)};
  if (std::ranges::count(channel.subscribers, id, &Subscriber::client) >= mostSubscriptions)
    return Error{.what = "there are " + std::to_string(mostSubscriptions) +
                         " subscriptions of channel " + std::to_string(wanted.channel) +
                         " already"};
  client.subscriptions[wanted.id] = &channel;
  if (channel.subscribers.empty()) feed(channel);
  channel.subscribers.push_back({id, wanted.id});
  if (&channel == field_) fieldSent_ = {};
  return {};
}

void FoxgloveServer::unsubscribe(ClientId id, Client& client, std::uint32_t subscription) {
  const auto found = client.subscriptions.find(subscription);
  if (found == client.subscriptions.end()) return;
  Channel& channel = *found->second;
  client.subscriptions.erase(found);
  std::erase_if(channel.subscribers, [&](const Subscriber& subscriber) {
    return subscriber.client == id && subscriber.subscription == subscription;
  });
  if (channel.subscribers.empty()) channel.feeds.clear();
}

void FoxgloveServer::reportFaults(ClientId client, Severity severity,
                                  const std::vector<Error>& faults) {
  if (faults.empty()) return;
  const std::string others =
      faults.size() == 1 ? "" : " (and " + std::to_string(faults.size() - 1) + " more faults)";
  status(client, severity, faults.front().text() + others);
}

void FoxgloveServer::sendJson(ClientId client, const Json& json) {
  // Texts of robots elsewhere may be any bytes.
  const auto text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  // Which channels there are is sent before and after what is of them.
  const bool urgent = json["op"] == "status" || json["op"] == "parameterValues";
  server_->send(
      client,
      {.body = std::make_shared<const std::string>(text), .droppable = false, .urgent = urgent});
}

void FoxgloveServer::status(ClientId client, Severity severity, const std::string& text) {
  sendJson(client, {{"op", "status"}, {"level", static_cast<int>(severity)}, {"message", text}});
}

std::vector<std::string> FoxgloveServer::takeNews() {
  const auto now = Clock::now();
  if (now < newsAsked_ + newsInterval) return {};
  newsAsked_ = now;
  std::vector<std::string> news;
  for (const auto& refusal : server_->refusals())
    if (reported_.insert(refusal.why).second)
      news.push_back("viewer " + refusal.first + " is not let in: " + refusal.why);
  return news;
}

}  // namespace gt
