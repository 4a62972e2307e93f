#pragma once
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "streams/Json.h"

namespace gt::testing {

/// A client of the Foxglove WebSocket protocol for tests.
class TestViewer {
 public:
  struct Data {
    std::uint32_t subscription = 0;
    std::uint64_t time = 0;
    std::string bytes;
  };

  /// Empty if the server turns it away.
  static std::optional<TestViewer> connect(std::uint16_t port,
                                           const std::string& subprotocol = "foxglove.sdk.v1") {
    TestViewer viewer;
    boost::beast::error_code failed;
    viewer.connectTo(port, failed);
    viewer.stream_->set_option(boost::beast::websocket::stream_base::decorator{[&](auto& request) {
      request.set(boost::beast::http::field::sec_websocket_protocol, subprotocol);
    }});
    viewer.stream_->read_message_max(64 << 20);
    boost::beast::websocket::response_type response;
    if (!failed) viewer.stream_->handshake(response, "localhost", "/", failed);
    if (failed) return std::nullopt;
    viewer.subprotocol = std::string{response[boost::beast::http::field::sec_websocket_protocol]};
    return viewer;
  }
  /// A line of a request's header.
  using Line = std::pair<boost::beast::http::field, std::string>;
  /// The status with which the server answers a request that has these lines beside what each has;
  /// 0 if it does not answer. `why` is what it says.
  static unsigned answerTo(std::uint16_t port, const std::vector<Line>& lines,
                           std::string* why = nullptr) {
    namespace http = boost::beast::http;
    TestViewer viewer;
    boost::beast::error_code failed;
    viewer.connectTo(port, failed);
    http::request<http::empty_body> request{http::verb::get, "/", 11};
    request.set(http::field::host, "localhost");
    request.set(http::field::sec_websocket_version, "13");
    request.set(http::field::sec_websocket_key, "dGhlIHNhbXBsZSBub25jZQ==");
    for (const auto& [field, value] : lines) request.insert(field, value);
    http::response_parser<http::string_body> response;
    boost::beast::flat_buffer buffer;
    if (!failed) http::write(viewer.socket(), request, failed);
    if (!failed) http::read_header(viewer.socket(), buffer, response, failed);
    if (failed) return 0;
    const unsigned status = response.get().result_int();
    if (status != 101) http::read(viewer.socket(), buffer, response, failed);
    if (why) *why = response.get().body();
    return status;
  }
  /// The status with which the server answers a browser that has loaded its page from an origin; 0
  /// if it does not answer.
  static unsigned answerTo(std::uint16_t port, const std::string& origin) {
    using boost::beast::http::field;
    std::vector<Line> lines{{field::connection, "upgrade"},
                            {field::upgrade, "websocket"},
                            {field::sec_websocket_protocol, "foxglove.sdk.v1"}};
    if (!origin.empty()) lines.emplace_back(field::origin, origin);
    return answerTo(port, lines);
  }

  void send(const std::string& text) {
    boost::beast::error_code failed;
    stream_->write(boost::asio::buffer(text), failed);
    isOpen = isOpen && !failed;
  }
  void subscribe(std::uint32_t id, const std::string& topic) {
    send(Json{{"op", "subscribe"},
              {"subscriptions", {{{"id", id}, {"channelId", channels.at(topic)["id"]}}}}}
             .dump());
  }

  /// Takes what has come, without waiting: not for the rest of a message either, nor for one after
  /// a ping.
  void read() {
    while (isOpen) {
      if (!reading_) reading_ = std::make_unique<Reading>(*stream_);
      context_->restart();
      context_->poll();
      if (!reading_->isDone) return;
      if (reading_->failed)
        isOpen = false;
      else
        take(boost::beast::buffers_to_string(reading_->buffer.data()), stream_->got_text());
      reading_.reset();
    }
  }
  boost::asio::ip::tcp::socket& socket() { return stream_->next_layer(); }

  bool isOpen = true;
  std::string subprotocol;
  std::vector<Json> texts;
  std::vector<std::size_t> dataBefore;   ///< How much of `data` has come before each text.
  std::map<std::string, Json> channels;  ///< By topics.
  std::vector<Data> data;
  std::uint64_t time = 0;  ///< ns

 private:
  using Stream = boost::beast::websocket::stream<boost::asio::ip::tcp::socket>;
  /// Of one message.
  struct Reading {
    explicit Reading(Stream& stream) {
      stream.async_read(buffer, [this](boost::beast::error_code why, std::size_t) {
        failed = why;
        isDone = true;
      });
    }
    boost::beast::flat_buffer buffer;
    boost::beast::error_code failed;
    bool isDone = false;
  };

  TestViewer()
      : context_{std::make_unique<boost::asio::io_context>()},
        stream_{std::make_unique<Stream>(*context_)} {}

  void connectTo(std::uint16_t port, boost::beast::error_code& failed) {
    socket().open(boost::asio::ip::tcp::v4(), failed);
    constexpr int fewBytes = 65536;  // that come without being read
    socket().set_option(boost::asio::socket_base::receive_buffer_size{fewBytes}, failed);
    socket().connect({boost::asio::ip::make_address("127.0.0.1"), port}, failed);
  }

  template <typename N>
  static N number(const std::string& bytes, std::size_t at) {
    N value{};
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
  }

  void take(const std::string& message, bool isText) {
    if (!isText) {
      if (message[0] == 2)
        time = number<std::uint64_t>(message, 1);
      else
        data.push_back({number<std::uint32_t>(message, 1), number<std::uint64_t>(message, 5),
                        message.substr(13)});
      return;
    }
    texts.push_back(*parseJson(message, "server"));
    dataBefore.push_back(data.size());
    const Json& json = texts.back();
    if (json["op"] == "advertise")
      for (const Json& channel : json["channels"]) channels[channel["topic"]] = channel;
    if (json["op"] == "unadvertise")
      for (const Json& id : json["channelIds"])
        std::erase_if(channels, [&](const auto& entry) { return entry.second["id"] == id; });
  }

  std::unique_ptr<boost::asio::io_context> context_;
  std::unique_ptr<Reading> reading_;
  std::unique_ptr<Stream> stream_;
};

}  // namespace gt::testing
