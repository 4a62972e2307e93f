#include "foxglove/WebSocketServer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <new>
#include <thread>

#include "base/FileDescriptor.h"
#include "support/TestAllocations.h"
#include "support/TestViewer.h"

namespace gt {
namespace {

using std::chrono::milliseconds;
using testing::TestViewer;

class WebSocketServerTest : public ::testing::Test {
 protected:
  void open(WebSocketServer::Options options = {}) {
    options.subprotocols = {"foxglove.sdk.v1", "two"};
    auto opened = WebSocketServer::open(options);
    ASSERT_TRUE(opened) << opened.error().text();
    server = std::move(*opened);
  }
  std::optional<TestViewer> connect() { return TestViewer::connect(server->port()); }
  void connectTo(const FileDescriptor& socket) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(server->port());
    EXPECT_EQ(::connect(socket.number(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  /// A connection that asks for nothing.
  FileDescriptor stranger() {
    FileDescriptor socket{::socket(AF_INET, SOCK_STREAM, 0)};
    connectTo(socket);
    return socket;
  }
  static bool isClosed(const FileDescriptor& socket) {
    char byte = 0;
    return recv(socket.number(), &byte, 1, MSG_DONTWAIT) == 0;
  }
  template <typename Condition>
  static bool waitFor(Condition holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{20};
    while (!holds()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(milliseconds{1});
    }
    return true;
  }
  /// Takes what has happened, and has dealt with it.
  std::vector<WebSocketServer::Event> take() {
    auto events = server->take();
    for (const auto& event : events) server->finish(event);
    return events;
  }
  /// Takes events until a client has connected.
  std::uint64_t takeClient() {
    std::uint64_t client = 0;
    EXPECT_TRUE(waitFor([&] {
      for (const auto& event : take())
        if (event.kind == WebSocketServer::EventKind::connected) client = event.client;
      return client != 0;
    }));
    return client;
  }

  std::unique_ptr<WebSocketServer> server;
};

/// However far behind the server's thread is: what is sent counts at once.
TEST_F(WebSocketServerTest, HoldsNoMoreThanItMayForAViewer) {
  open();
  const auto viewer = connect();
  ASSERT_TRUE(viewer);
  const std::uint64_t client = takeClient();
  constexpr std::size_t size = 1 << 20;
  const auto body = std::make_shared<const std::string>(size, 'x');
  long most = 0;
  for (int i = 0; i < 20'000; ++i) {
    server->send(client, {.binary = true, .body = body});
    most = std::max(most, body.use_count());
  }
  EXPECT_LE(most, 1 + 4) << "MB, one of them held by this test";
  EXPECT_GT(server->dropped(), 10'000u);
}

TEST_F(WebSocketServerTest, ReplacesWhatWaitsByTheNewest) {
  open();
  auto viewer = connect();
  ASSERT_TRUE(viewer);
  const std::uint64_t client = takeClient();
  const std::string head(13, '\1');
  constexpr std::size_t much = 1 << 20;
  std::vector<std::weak_ptr<const std::string>> bodies;
  for (int i = 0; i < 1000; ++i) {
    auto body = std::make_shared<const std::string>(much, static_cast<char>('a' + i % 26));
    bodies.push_back(body);
    server->send(client, {.binary = true, .head = head, .body = std::move(body), .newestOf = 7});
  }
  const auto held = std::ranges::count_if(bodies, [](const auto& body) { return !body.expired(); });
  EXPECT_LE(held, 3) << "the newest, and those being sent meanwhile";
  EXPECT_TRUE(waitFor([&] {
    viewer->read();
    return !viewer->data.empty() && viewer->data.back().bytes[0] == 'a' + 999 % 26;
  })) << "it gets the newest";
}

/// Messages that must not be dropped are not kept without a bound, either.
TEST_F(WebSocketServerTest, DisconnectsAViewerThatTakesNothing) {
  open({.mostWaiting = 1 << 16});
  const auto viewer = connect();
  ASSERT_TRUE(viewer);
  const std::uint64_t client = takeClient();
  const auto body = std::make_shared<const std::string>(1 << 16, 'x');
  long most = 0;
  EXPECT_TRUE(waitFor([&] {
    server->send(client, {.body = body, .droppable = false});
    most = std::max(most, body.use_count());
    return std::ranges::any_of(
        take(), [](const auto& event) { return event.kind == WebSocketServer::EventKind::closed; });
  }));
  EXPECT_LE(most, 1 + 17);
}

TEST_F(WebSocketServerTest, ReadsNoMoreThanIsTaken) {
  open();
  auto viewer = connect();
  ASSERT_TRUE(viewer);
  takeClient();
  constexpr std::size_t size = 500'000, count = 64;
  std::thread sender{[&] {
    for (std::size_t i = 0; i < count; ++i) viewer->send(std::string(size, 'x'));
  }};
  std::this_thread::sleep_for(milliseconds{500});
  std::size_t received = 0, mostAtOnce = 0;
  EXPECT_TRUE(waitFor([&] {
    std::size_t bytes = 0;
    for (const auto& event : take()) bytes += event.data.size();
    mostAtOnce = std::max(mostAtOnce, bytes);
    received += bytes;
    return received == count * size;
  })) << "but all of it in the end";
  EXPECT_LE(mostAtOnce, 3 * size);
  sender.join();
}

/// Taking is not dealing with: what a client has sent waits for its turn.
TEST_F(WebSocketServerTest, ReadsNoMoreThanIsDealtWith) {
  open();
  auto viewer = connect();
  ASSERT_TRUE(viewer);
  takeClient();
  constexpr std::size_t count = 1000;
  std::thread sender{[&] {
    for (std::size_t i = 0; i < count; ++i) viewer->send("x");
  }};
  std::vector<WebSocketServer::Event> waiting;
  const auto more = [&] {
    for (auto& event : server->take()) waiting.push_back(std::move(event));
    return waiting.size();
  };
  EXPECT_TRUE(waitFor([&] { return more() == 64; }));
  std::this_thread::sleep_for(milliseconds{200});
  EXPECT_EQ(more(), 64u);
  std::size_t received = 0;
  EXPECT_TRUE(waitFor([&] {
    received += more();
    for (const auto& event : std::exchange(waiting, {})) server->finish(event);
    return received == count;
  }));
  sender.join();
}

TEST_F(WebSocketServerTest, ReadsNoMoreSmallMessagesThanAreTaken) {
  open();
  auto viewer = connect();
  ASSERT_TRUE(viewer);
  takeClient();
  constexpr std::size_t count = 5000;
  std::thread sender{[&] {
    for (std::size_t i = 0; i < count; ++i) viewer->send("x");
  }};
  std::this_thread::sleep_for(milliseconds{200});
  std::size_t received = 0, mostAtOnce = 0;
  EXPECT_TRUE(waitFor([&] {
    const std::size_t events = take().size();
    mostAtOnce = std::max(mostAtOnce, events);
    received += events;
    return received == count;
  }));
  EXPECT_LE(mostAtOnce, 64u);
  sender.join();
}

/// Who comes and goes leaves what he sent behind, until it is taken.
TEST_F(WebSocketServerTest, LetsNobodyInWhileMuchIsNotTaken) {
  open({.mostClients = 2});
  const auto sendMuch = [&] {
    auto viewer = connect();
    if (viewer) viewer->send(std::string(1'000'000, 'x'));
    return viewer.has_value();
  };
  int letIn = 0;
  EXPECT_TRUE(waitFor([&] {
    letIn += sendMuch();
    return letIn >= 3 && !connect();
  }));
  EXPECT_LE(letIn, 10);
  // Not only for as long as it does not know who has gone.
  EXPECT_TRUE(waitFor([&] {
    const auto end = std::chrono::steady_clock::now() + milliseconds{500};
    while (std::chrono::steady_clock::now() < end)
      if (connect()) return false;
    return true;
  }));
  take();
  EXPECT_TRUE(waitFor([&] { return connect().has_value(); }));
}

/// A list may stand in several lines of a request's header.
TEST_F(WebSocketServerTest, TakesListsInSeveralLines) {
  using boost::beast::http::field;
  open();
  const auto answer = [&](std::vector<TestViewer::Line> lines) {
    lines.emplace_back(field::upgrade, "websocket");
    return TestViewer::answerTo(server->port(), lines);
  };
  const TestViewer::Line upgrade{field::connection, "Upgrade"},
      keep{field::connection, "keep-alive"}, ours{field::sec_websocket_protocol, "foxglove.sdk.v1"},
      other{field::sec_websocket_protocol, "chat, x"};
  EXPECT_EQ(answer({upgrade, other, ours}), 101u);
  EXPECT_EQ(answer({upgrade, ours, other}), 101u);
  EXPECT_EQ(answer({keep, upgrade, ours}), 101u);
  EXPECT_EQ(answer({upgrade, keep, ours}), 101u);
  EXPECT_EQ(answer({upgrade, other, other}), 400u);
  EXPECT_EQ(answer({keep, ours}), 400u);
}

TEST_F(WebSocketServerTest, CountsWhomItDoesNotLetIn) {
  using boost::beast::http::field;
  open({.mostClients = 1, .introduction = milliseconds{1000}});
  const std::vector<TestViewer::Line> none;
  std::string why;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(TestViewer::answerTo(server->port(), none, &why), 400u);
  EXPECT_EQ(why, "This is a WebSocket server of the subprotocols foxglove.sdk.v1 and two.\n");
  EXPECT_EQ(TestViewer::answerTo(server->port(), "https://elsewhere.example"), 403u);
  const auto viewer = connect();
  EXPECT_EQ(TestViewer::answerTo(server->port(), ""), 503u);
  const FileDescriptor silent = stranger(), talkative = stranger();
  EXPECT_EQ(::send(talkative.number(), "HELLO\r\n\r\n", 9, 0), 9);
  const auto refused = [&](std::string_view part) {
    for (const auto& refusal : server->refusals())
      if (refusal.why.find(part) != refusal.why.npos) {
        EXPECT_EQ(refusal.first, "127.0.0.1");
        return refusal.count;
      }
    return std::uint64_t{0};
  };
  EXPECT_EQ(refused("subprotocols"), 3u);
  EXPECT_EQ(refused("Pages"), 1u);
  EXPECT_EQ(refused("too many"), 1u);
  EXPECT_TRUE(waitFor([&] { return refused("asked for nothing") == 1; }));
  EXPECT_TRUE(waitFor([&] { return refused("none of HTTP") == 1; }));
}

TEST_F(WebSocketServerTest, SendsWhatIsUrgentBeforeWhatWaits) {
  open();
  auto viewer = connect();
  ASSERT_TRUE(viewer);
  const std::uint64_t client = takeClient();
  const auto much = std::make_shared<const std::string>(500'000, 'x');
  constexpr std::size_t count = 7;
  for (std::size_t i = 0; i < count; ++i)
    server->send(client, {.binary = true, .head = std::string(13, '\1'), .body = much});
  server->send(client, {.body = std::make_shared<const std::string>("{\"op\":1}"),
                        .droppable = false,
                        .urgent = true});
  EXPECT_TRUE(waitFor([&] {
    viewer->read();
    return viewer->data.size() == count && !viewer->texts.empty();
  }));
  EXPECT_LE(viewer->dataBefore.front(), 2u) << "what was being sent, and what the system holds";
}

TEST_F(WebSocketServerTest, IdleConnectionsLockNobodyOut) {
  open();
  std::vector<FileDescriptor> idle;
  for (int i = 0; i < 200; ++i) idle.push_back(stranger());
  const auto viewer = connect();
  EXPECT_TRUE(viewer);
  EXPECT_TRUE(waitFor([&] { return std::ranges::count_if(idle, isClosed) >= 200 - 64; }));
  EXPECT_FALSE(isClosed(idle.back())) << "the oldest leave first";
}

TEST_F(WebSocketServerTest, ConnectionsThatAskForNothingAreClosed) {
  open({.introduction = milliseconds{100}});
  const FileDescriptor idle = stranger();
  const auto viewer = connect();
  ASSERT_TRUE(viewer);
  takeClient();
  EXPECT_TRUE(waitFor([&] { return isClosed(idle); }));
  std::this_thread::sleep_for(milliseconds{300});
  EXPECT_THAT(take(), ::testing::IsEmpty()) << "but not a viewer that only listens";
}

TEST_F(WebSocketServerTest, OnlySoManyViewersAreLetIn) {
  open({.mostClients = 3});
  std::vector<std::optional<TestViewer>> viewers(3);
  for (auto& viewer : viewers) EXPECT_TRUE(viewer = connect());
  EXPECT_EQ(TestViewer::answerTo(server->port(), ""), 503u);
  viewers.front().reset();
  EXPECT_TRUE(waitFor([&] { return TestViewer::answerTo(server->port(), "") == 101u; }));
}

double processorSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

TEST_F(WebSocketServerTest, WaitsWhileThereAreNoDescriptors) {
  open();
  std::vector<FileDescriptor> waiting;
  for (int i = 0; i < 3; ++i) waiting.emplace_back(::socket(AF_INET, SOCK_STREAM, 0));
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &before), 0);
  const FileDescriptor next{dup(0)};  // all with lower numbers are in use
  const rlimit few{static_cast<rlim_t>(next.number()), before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
  for (const FileDescriptor& socket : waiting) connectTo(socket);
  const double began = processorSeconds();
  std::this_thread::sleep_for(milliseconds{1000});
  EXPECT_LT(processorSeconds() - began, 0.05);
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_TRUE(connect()) << "it goes on when there are some";
}

TEST_F(WebSocketServerTest, ThrowsWhatHasEndedItsThread) {
  open();
  auto viewer = connect();
  ASSERT_TRUE(viewer);
  takeClient();
  const auto takeFails = [&] {
    try {
      server->take();
      return false;
    } catch (const std::bad_alloc&) {
      return true;
    }
  };
  EXPECT_FALSE(takeFails());
  {
    const NoMemoryElsewhere none;
    viewer->send(std::string(10'000, 'x'));
    EXPECT_TRUE(waitFor(takeFails));
  }
  EXPECT_TRUE(takeFails());
}

}  // namespace
}  // namespace gt
