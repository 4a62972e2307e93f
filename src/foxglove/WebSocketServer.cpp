#include "foxglove/WebSocketServer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "network/LoopbackPeer.h"

namespace gt {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using asio::ip::tcp;
using beast::error_code;

constexpr std::size_t longestMessage = 1 << 20;  ///< Bytes, of a client.
constexpr std::size_t longestRequest = 16 << 10;
constexpr int sendBuffer = 256 << 10;  ///< Bytes.
/// A client is not read while so much of it was not taken yet.
constexpr std::size_t mostUnreadEvents = 64, mostUnreadBytes = 1 << 20;
/// Bytes that an event takes beside its text.
constexpr std::size_t overhead = 128;
constexpr std::chrono::seconds patience{30};
/// Without descriptors, until the next connection is accepted.
constexpr std::chrono::milliseconds acceptAgain{100};

using Request = http::request<http::empty_body>;

/// A list may stand in several lines of a header, which mean the same as one (RFC 9110, 5.3).
void joinLines(Request& request, http::field name) {
  std::string all;
  const auto [first, last] = request.equal_range(name);
  for (auto line = first; line != last; ++line) {
    if (!all.empty()) all += ", ";
    all.append(line->value().data(), line->value().size());
  }
  if (!all.empty()) request.set(name, all);
}

/// The first of the server's subprotocols that a client offers; empty if there is none.
std::string chosen(const Request& request, const std::vector<std::string>& known) {
  const auto offered = request[http::field::sec_websocket_protocol];
  for (const std::string& protocol : known)
    for (const auto& word : http::token_list{offered})
      if (word == protocol) return protocol;
  return "";
}

/// Of who has connected; empty if it is gone already.
std::string addressOf(const tcp::socket& socket) {
  error_code gone;
  const auto peer = socket.remote_endpoint(gone);
  return gone ? "" : peer.address().to_string();
}

/// Names in a sentence.
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

/// Whether a page may connect that a browser has loaded from there. A browser lets any page connect
/// to this machine, and names where the page is from; other programs name nothing.
bool isTrusted(std::string_view origin, const std::vector<std::string>& trusted) {
  if (origin.empty() || std::ranges::find(trusted, origin) != trusted.end()) return true;
  for (const std::string_view own : {"http://localhost", "https://localhost", "http://127.0.0.1",
                                     "https://127.0.0.1", "http://[::1]", "https://[::1]"}) {
    if (!origin.starts_with(own)) continue;
    const std::string_view port = origin.substr(own.size());
    if (port.empty() || (port[0] == ':' && port.find_first_not_of("0123456789", 1) == port.npos))
      return true;
  }
  return false;
}

}  // namespace

class WebSocketServer::Server {
 public:
  explicit Server(const Options& options) : options_{options} {}
  ~Server() {
    asio::post(context_, [this] {
      error_code ignored;
      acceptor_.close(ignored);
      connections_.clear();
      context_.stop();
    });
    if (thread_.joinable()) thread_.join();
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  Result<void> open() {
    const std::string place = options_.address + ":" + std::to_string(options_.port);
    error_code failed;
    const auto address = asio::ip::make_address(options_.address, failed);
    if (failed) return Error{.field = place, .what = "is no address of this machine"};
    const tcp::endpoint endpoint{address, options_.port};
    acceptor_.open(endpoint.protocol(), failed);
    if (!failed) acceptor_.set_option(asio::socket_base::reuse_address{true}, failed);
    if (!failed) acceptor_.bind(endpoint, failed);
    if (!failed) acceptor_.listen(asio::socket_base::max_listen_connections, failed);
    if (failed) return Error{.field = place, .what = failed.message()};
    port_ = acceptor_.local_endpoint().port();
    accept();
    thread_ = std::thread{[this] { run(); }};
    return {};
  }

  std::uint16_t port() const { return port_; }
  std::uint64_t dropped() const { return dropped_; }

  std::vector<Event> take() {
    if (!news_) return {};
    std::vector<Event> events;
    const std::lock_guard lock{mutex_};
    if (failure_) std::rethrow_exception(failure_);
    events.swap(events_);
    news_ = false;
    return events;
  }

  void finish(const Event& event) {
    const std::lock_guard lock{mutex_};
    const auto unread = unread_.find(event.client);
    if (unread == unread_.end()) return;
    const std::size_t size = overhead + event.data.size();
    --unread->second.events;
    unread->second.bytes -= size;
    unreadBytes_ -= size;
    if (unread->second.isHeld && !unread->second.isMuch()) {
      unread->second.isHeld = false;
      asio::post(context_, [this, client = event.client] {
        if (const auto found = connections_.find(client); found != connections_.end())
          found->second->resume();
      });
    }
    if (unread->second.events == 0) unread_.erase(unread);
  }

  bool takes(std::uint64_t client, std::uint32_t newestOf) {
    const std::lock_guard lock{mutex_};
    const auto outbox = outboxes_.find(client);
    return outbox != outboxes_.end() && outbox->second.takes(newestOf);
  }

  std::vector<Refusal> refusals() {
    const std::lock_guard lock{mutex_};
    return refusals_;
  }

  void send(std::uint64_t client, WebSocketMessage message) {
    const auto outcome = [&] {
      const std::lock_guard lock{mutex_};
      const auto outbox = outboxes_.find(client);
      return outbox == outboxes_.end()
                 ? WebSocketOutbox::Outcome::waits
                 : outbox->second.put(std::move(message), options_.mostWaiting);
    }();
    dropped_ += outcome == WebSocketOutbox::Outcome::dropped;
    if (outcome != WebSocketOutbox::Outcome::first && outcome != WebSocketOutbox::Outcome::full)
      return;
    asio::post(context_, [this, client, isFull = outcome == WebSocketOutbox::Outcome::full] {
      const auto found = connections_.find(client);
      if (found == connections_.end()) return;
      const std::shared_ptr<Connection> connection = found->second;  // lives until it has ended
      isFull ? connection->end() : connection->write();
    });
  }

 private:
  /// What an exception leaves is no server any more.
  void run() {
    try {
      context_.run();
    } catch (...) {
      const std::lock_guard lock{mutex_};
      failure_ = std::current_exception();
      news_ = true;
    }
  }

  /// One client. All of it runs on the server's thread.
  class Connection : public std::enable_shared_from_this<Connection> {
   public:
    Connection(Server& server, std::uint64_t number, tcp::socket socket)
        : server_{server},
          number_{number},
          address_{addressOf(socket)},
          stream_{std::move(socket)} {}

    void run() {
      parser_.body_limit(0);
      parser_.header_limit(longestRequest);
      beast::get_lowest_layer(stream_).expires_after(server_.options_.introduction);
      http::async_read_header(
          stream_.next_layer(), buffer_, parser_,
          [self = shared_from_this()](error_code failed, std::size_t) { self->requested(failed); });
    }

    /// Sends what waits, one message after another.
    void write() {
      auto next = server_.nextFor(number_);
      if (!next) return;
      sending_ = std::move(*next);
      stream_.binary(sending_.binary);
      stream_.async_write(std::array<asio::const_buffer, 2>{asio::buffer(sending_.head),
                                                            asio::buffer(*sending_.body)},
                          [self = shared_from_this()](error_code failed, std::size_t) {
                            if (failed) return self->end();
                            self->write();
                          });
    }

    /// It leaves for who comes later.
    void displace() {
      server_.countRefusal(address_, "it asked for nothing");
      end();
    }
    /// Whether it has become a client, or is about to.
    bool isClient() const { return isClient_; }
    void resume() {
      if (std::exchange(paused_, false)) read();
    }

    void end() {
      if (std::exchange(ended_, true)) return;
      if (std::exchange(open_, false)) server_.leave(number_);
      beast::get_lowest_layer(stream_).close();
      server_.connections_.erase(number_);
    }

   private:
    void requested(error_code failed) {
      if (failed == beast::error::timeout)
        server_.countRefusal(address_, "it asked for nothing");
      else if (failed.category() == http::make_error_code(http::error::bad_method).category() &&
               failed != http::error::end_of_stream && failed != http::error::partial_message)
        server_.countRefusal(address_, "its request is none of HTTP");
      if (failed) return end();
      Request& request = parser_.get();
      for (const auto list :
           {http::field::connection, http::field::upgrade, http::field::sec_websocket_protocol})
        joinLines(request, list);
      const std::string protocol = chosen(request, server_.options_.subprotocols);
      if (!websocket::is_upgrade(request) || protocol.empty())
        return refuse(http::status::bad_request, "This is a WebSocket server of the subprotocols " +
                                                     listed(server_.options_.subprotocols) + ".");
      const auto origin = request[http::field::origin];
      if (!isTrusted({origin.data(), origin.size()}, server_.options_.origins))
        return refuse(http::status::forbidden, "Pages from there may not connect.");
      const int file = beast::get_lowest_layer(stream_).socket().native_handle();
      if (isOverLoopback(file) && !isPeerOfThisUser(file))
        return refuse(http::status::forbidden, "This server is another user's.");
      if (!server_.hasRoom())
        return refuse(http::status::service_unavailable, "There are too many clients.");
      isClient_ = true;
      beast::get_lowest_layer(stream_).expires_never();
      stream_.set_option(
          websocket::stream_base::timeout{server_.options_.introduction, patience, true});
      stream_.set_option(websocket::stream_base::decorator{[protocol](auto& response) {
        response.set(http::field::sec_websocket_protocol, protocol);
      }});
      stream_.read_message_max(longestMessage);
      stream_.async_accept(request, [self = shared_from_this()](error_code refused) {
        if (refused) return self->end();
        self->open_ = true;
        error_code ignored;
        auto& socket = beast::get_lowest_layer(self->stream_).socket();
        socket.set_option(tcp::no_delay{true}, ignored);
        // What the system has taken can be neither replaced nor dropped.
        socket.set_option(asio::socket_base::send_buffer_size{sendBuffer}, ignored);
        self->buffer_.clear();
        self->server_.join(self->number_);
        self->read();
      });
    }

    void refuse(http::status status, const std::string& why) {
      server_.countRefusal(address_, why);
      auto response = std::make_shared<http::response<http::string_body>>(status, 11);
      response->set(http::field::content_type, "text/plain");
      response->keep_alive(false);
      response->body() = why + "\n";
      response->prepare_payload();
      http::async_write(
          stream_.next_layer(), *response,
          [self = shared_from_this(), response](error_code, std::size_t) { self->end(); });
    }

    void read() {
      stream_.async_read(buffer_, [self = shared_from_this()](error_code failed, std::size_t) {
        if (failed) return self->end();
        const bool binary = self->stream_.got_binary();
        self->paused_ =
            !self->server_.report({binary ? EventKind::binary : EventKind::text, self->number_,
                                   beast::buffers_to_string(self->buffer_.data())});
        self->buffer_.clear();
        if (!self->paused_) self->read();
      });
    }

    Server& server_;
    const std::uint64_t number_;
    const std::string address_;
    websocket::stream<beast::tcp_stream> stream_;
    beast::flat_buffer buffer_;
    http::request_parser<http::empty_body> parser_;
    WebSocketMessage sending_;
    bool isClient_ = false, open_ = false, paused_ = false, ended_ = false;
  };

  void accept() {
    acceptor_.async_accept([this](error_code failed, tcp::socket socket) {
      if (failed == asio::error::operation_aborted) return;
      if (failed) return acceptLater();
      makeRoom();
      const std::uint64_t number = ++numbers_;
      connections_.emplace(number, std::make_shared<Connection>(*this, number, std::move(socket)))
          .first->second->run();
      accept();
    });
  }

  /// As long as there are no descriptors, each attempt would fail at once.
  void acceptLater() {
    acceptTimer_.expires_after(acceptAgain);
    acceptTimer_.async_wait([this](error_code aborted) {
      if (!aborted) accept();
    });
  }

  /// The oldest connection that has not asked for anything yet leaves for who comes later.
  void makeRoom() {
    const auto isStranger = [](const auto& entry) { return !entry.second->isClient(); };
    const auto strangers = std::ranges::count_if(connections_, isStranger);
    if (strangers < static_cast<std::ptrdiff_t>(options_.mostStrangers)) return;
    const std::shared_ptr<Connection> oldest =  // lives until it has ended
        std::ranges::find_if(connections_, isStranger)->second;
    oldest->displace();
  }

  void countRefusal(const std::string& who, const std::string& why) {
    const std::lock_guard lock{mutex_};
    const auto known = std::ranges::find(refusals_, why, &Refusal::why);
    if (known == refusals_.end())
      refusals_.push_back({why, who, 1});
    else
      ++known->count;
  }

  /// Whether one more client has room: for itself, and for what it may send.
  bool hasRoom() {
    const auto clients = std::ranges::count_if(
        connections_, [](const auto& entry) { return entry.second->isClient(); });
    const std::lock_guard lock{mutex_};
    return static_cast<std::size_t>(clients) < options_.mostClients &&
           unreadBytes_ < options_.mostClients * mostUnreadBytes;
  }

  void join(std::uint64_t client) {
    {
      const std::lock_guard lock{mutex_};
      outboxes_[client];
    }
    report({EventKind::connected, client});
  }
  void leave(std::uint64_t client) {
    report({EventKind::closed, client});
    const std::lock_guard lock{mutex_};
    outboxes_.erase(client);
  }
  std::optional<WebSocketMessage> nextFor(std::uint64_t client) {
    const std::lock_guard lock{mutex_};
    const auto outbox = outboxes_.find(client);
    return outbox == outboxes_.end() ? std::nullopt : outbox->second.take();
  }

  /// Returns whether the client may be read: not while much of it was not taken.
  bool report(Event event) {
    const std::lock_guard lock{mutex_};
    Unread& unread = unread_[event.client];
    const std::size_t size = overhead + event.data.size();
    ++unread.events;
    unread.bytes += size;
    unreadBytes_ += size;
    unread.isHeld = unread.isMuch();
    events_.push_back(std::move(event));
    news_ = true;
    return !unread.isHeld;
  }

  struct Unread {
    std::size_t events = 0, bytes = 0;
    bool isHeld = false;  ///< The client is not read until some are finished.

    bool isMuch() const { return events >= mostUnreadEvents || bytes >= mostUnreadBytes; }
  };

  const Options options_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_{context_};
  asio::steady_timer acceptTimer_{context_};
  std::uint16_t port_ = 0;
  std::map<std::uint64_t, std::shared_ptr<Connection>> connections_;
  std::uint64_t numbers_ = 0;
  std::mutex mutex_;  ///< Of all that follows, unless it is atomic.
  std::map<std::uint64_t, WebSocketOutbox> outboxes_;
  std::vector<Event> events_;
  std::map<std::uint64_t, Unread> unread_;  ///< Of each client's events that are not finished.
  std::size_t unreadBytes_ = 0;             ///< Of all.
  std::vector<Refusal> refusals_;
  std::exception_ptr failure_;  ///< Of the server's thread, which has ended then.
  std::atomic<bool> news_ = false;
  std::atomic<std::uint64_t> dropped_ = 0;
  std::thread thread_;
};

WebSocketServer::WebSocketServer(std::unique_ptr<Server> server) : server_{std::move(server)} {}
WebSocketServer::~WebSocketServer() = default;

Result<std::unique_ptr<WebSocketServer>> WebSocketServer::open(const Options& options) {
  auto server = std::make_unique<Server>(options);
  if (auto done = server->open(); !done) return done.error();
  return std::unique_ptr<WebSocketServer>{new WebSocketServer{std::move(server)}};
}

std::uint16_t WebSocketServer::port() const {
  return server_->port();
}

std::vector<WebSocketServer::Event> WebSocketServer::take() {
  return server_->take();
}

void WebSocketServer::finish(const Event& event) {
  server_->finish(event);
}

bool WebSocketServer::takes(std::uint64_t client, std::uint32_t newestOf) const {
  return server_->takes(client, newestOf);
}

std::vector<WebSocketServer::Refusal> WebSocketServer::refusals() const {
  return server_->refusals();
}

void WebSocketServer::send(std::uint64_t client, WebSocketMessage message) {
  server_->send(client, std::move(message));
}

std::uint64_t WebSocketServer::dropped() const {
  return server_->dropped();
}

}  // namespace gt
