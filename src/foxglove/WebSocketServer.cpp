#include "foxglove/WebSocketServer.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
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
constexpr int sendBuffer = 256 << 10;     ///< Bytes.
constexpr std::size_t mostEvents = 1000;  ///< Clients are not read while more wait.
constexpr std::chrono::seconds patience{30};

/// The first of the server's subprotocols that a client offers; empty if there is none.
std::string chosen(std::string_view offered, const std::vector<std::string>& known) {
  for (const std::string& protocol : known)
    for (const auto& word : http::token_list{{offered.data(), offered.size()}})
      if (word == protocol) return protocol;
  return "";
}

/// Whether a page may connect that a browser has loaded from there. A browser lets any page connect
/// to this machine, and names where the page is from; other programs name nothing.
bool isTrusted(std::string_view origin, const std::vector<std::string>& trusted) {
  if (origin.empty() || std::ranges::find(trusted, origin) != trusted.end()) return true;
  for (const std::string_view own : {"http://localhost", "https://localhost", "http://127.0.0.1",
                                     "https://127.0.0.1", "http://[::1]", "https://[::1]"})
    if (origin == own || (origin.starts_with(own) && origin[own.size()] == ':')) return true;
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
    thread_ = std::thread{[this] { context_.run(); }};
    return {};
  }

  std::uint16_t port() const { return port_; }
  std::uint64_t dropped() const { return dropped_; }

  std::vector<Event> take() {
    if (!news_) return {};
    std::vector<Event> events;
    {
      const std::lock_guard lock{mutex_};
      events.swap(events_);
      news_ = false;
    }
    if (events.size() >= mostEvents)
      asio::post(context_, [this] {
        for (const auto& [number, connection] : connections_) connection->resume();
      });
    return events;
  }

  void send(std::uint64_t client, WebSocketMessage message) {
    asio::post(context_, [this, client, message = std::move(message)]() mutable {
      const auto found = connections_.find(client);
      if (found != connections_.end()) found->second->send(std::move(message));
    });
  }

 private:
  /// One client. All of it runs on the server's thread.
  class Connection : public std::enable_shared_from_this<Connection> {
   public:
    Connection(Server& server, std::uint64_t number, tcp::socket socket)
        : server_{server}, number_{number}, stream_{std::move(socket)} {}

    void run() {
      parser_.body_limit(0);
      parser_.header_limit(longestRequest);
      beast::get_lowest_layer(stream_).expires_after(patience);
      http::async_read_header(
          stream_.next_layer(), buffer_, parser_,
          [self = shared_from_this()](error_code failed, std::size_t) { self->requested(failed); });
    }

    void send(WebSocketMessage message) {
      if (!open_) return;
      const std::size_t size = message.head.size() + message.body->size();
      if (message.newestOf != 0)
        // The first one is being sent.
        for (std::size_t i = writing_ ? 1 : 0; i < waiting_.size(); ++i)
          if (waiting_[i].newestOf == message.newestOf) {
            waitingBytes_ += size - sizeOf(waiting_[i]);
            waiting_[i] = std::move(message);
            ++server_.dropped_;
            return;
          }
      const std::size_t most = server_.options_.mostWaiting;
      if (message.droppable && waitingBytes_ + size > most && !waiting_.empty()) {
        ++server_.dropped_;
        return;
      }
      constexpr std::size_t muchMore = 16;
      if (waitingBytes_ > muchMore * most) return end();
      waitingBytes_ += size;
      waiting_.push_back(std::move(message));
      if (!writing_) write();
    }

    bool open() const { return open_; }
    void resume() {
      if (std::exchange(paused_, false)) read();
    }

    void end() {
      if (std::exchange(ended_, true)) return;
      if (std::exchange(open_, false)) server_.report({EventKind::closed, number_});
      beast::get_lowest_layer(stream_).close();
      server_.connections_.erase(number_);
    }

   private:
    static std::size_t sizeOf(const WebSocketMessage& message) {
      return message.head.size() + message.body->size();
    }

    void requested(error_code failed) {
      if (failed) return end();
      const auto& request = parser_.get();
      const auto offered = request[http::field::sec_websocket_protocol];
      const std::string protocol =
          chosen({offered.data(), offered.size()}, server_.options_.subprotocols);
      if (!websocket::is_upgrade(request) || protocol.empty())
        return refuse(http::status::bad_request, "This is a WebSocket server of the subprotocol " +
                                                     server_.options_.subprotocols.front() + ".\n");
      const auto origin = request[http::field::origin];
      if (!isTrusted({origin.data(), origin.size()}, server_.options_.origins))
        return refuse(http::status::forbidden, "Pages from there may not connect.\n");
      const int file = beast::get_lowest_layer(stream_).socket().native_handle();
      if (isOverLoopback(file) && !isPeerOfThisUser(file))
        return refuse(http::status::forbidden, "This server is another user's.\n");
      if (server_.connections_.size() > server_.options_.mostClients)
        return refuse(http::status::service_unavailable, "There are too many clients.\n");
      beast::get_lowest_layer(stream_).expires_never();
      stream_.set_option(websocket::stream_base::timeout{patience, patience, true});
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
        self->server_.report({EventKind::connected, self->number_});
        self->read();
      });
    }

    void refuse(http::status status, const std::string& why) {
      auto response = std::make_shared<http::response<http::string_body>>(status, 11);
      response->set(http::field::content_type, "text/plain");
      response->keep_alive(false);
      response->body() = why;
      response->prepare_payload();
      http::async_write(
          stream_.next_layer(), *response,
          [self = shared_from_this(), response](error_code, std::size_t) { self->end(); });
    }

    void read() {
      stream_.async_read(buffer_, [self = shared_from_this()](error_code failed, std::size_t) {
        if (failed) return self->end();
        const bool binary = self->stream_.got_binary();
        const std::size_t waiting =
            self->server_.report({binary ? EventKind::binary : EventKind::text, self->number_,
                                  beast::buffers_to_string(self->buffer_.data())});
        self->buffer_.clear();
        self->paused_ = waiting >= mostEvents;
        if (!self->paused_) self->read();
      });
    }

    void write() {
      writing_ = true;
      const WebSocketMessage& message = waiting_.front();
      stream_.binary(message.binary);
      stream_.async_write(std::array{asio::buffer(message.head), asio::buffer(*message.body)},
                          [self = shared_from_this()](error_code failed, std::size_t) {
                            if (failed) return self->end();
                            self->waitingBytes_ -= sizeOf(self->waiting_.front());
                            self->waiting_.pop_front();
                            self->writing_ = false;
                            if (!self->waiting_.empty()) self->write();
                          });
    }

    Server& server_;
    const std::uint64_t number_;
    websocket::stream<beast::tcp_stream> stream_;
    beast::flat_buffer buffer_;
    http::request_parser<http::empty_body> parser_;
    std::deque<WebSocketMessage> waiting_;  ///< The first one is being sent if `writing_`.
    std::size_t waitingBytes_ = 0;
    bool writing_ = false, open_ = false, paused_ = false, ended_ = false;
  };

  void accept() {
    acceptor_.async_accept([this](error_code failed, tcp::socket socket) {
      if (failed == asio::error::operation_aborted) return;
      if (!failed) {
        makeRoom();
        const std::uint64_t number = ++numbers_;
        connections_.emplace(number, std::make_shared<Connection>(*this, number, std::move(socket)))
            .first->second->run();
      }
      accept();
    });
  }

  /// Who has connected and is no client yet leaves for who comes later.
  void makeRoom() {
    if (connections_.size() < options_.mostClients) return;
    const auto stranger =
        std::ranges::find_if(connections_, [](const auto& c) { return !c.second->open(); });
    if (stranger == connections_.end()) return;
    const std::shared_ptr<Connection> connection = stranger->second;  // lives until it has ended
    connection->end();
  }

  /// Returns how many events wait.
  std::size_t report(Event event) {
    const std::lock_guard lock{mutex_};
    events_.push_back(std::move(event));
    news_ = true;
    return events_.size();
  }

  const Options options_;
  asio::io_context context_{1};
  tcp::acceptor acceptor_{context_};
  std::uint16_t port_ = 0;
  std::map<std::uint64_t, std::shared_ptr<Connection>> connections_;
  std::uint64_t numbers_ = 0;
  std::mutex mutex_;  ///< Of the events.
  std::vector<Event> events_;
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

void WebSocketServer::send(std::uint64_t client, WebSocketMessage message) {
  server_->send(client, std::move(message));
}

std::uint64_t WebSocketServer::dropped() const {
  return server_->dropped();
}

}  // namespace gt
