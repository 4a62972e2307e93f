#include <gmock/gmock.h>

#include <fstream>

#include "support/TestFoxglove.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// What this program has of the memory, in MB.
double residentMemory() {
  std::ifstream file{"/proc/self/statm"};
  double pages = 0, resident = 0;
  file >> pages >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

TEST_F(FoxgloveServerTest, RefusesWhatIsNoRequest) {
  auto viewer = connect();
  for (const char* wrong :
       {"{", "[]", R"({"op":1})", R"({"op":"advertise","channels":[]})", R"({"op":"subscribe"})",
        R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":1}]})",
        R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":99999}]})",
        R"({"op":"unsubscribe","subscriptionIds":["x"]})",
        R"({"op":"setParameters","parameters":[{"name":"blue1","value":1}]})"}) {
    viewer.texts.clear();
    viewer.send(wrong);
    EXPECT_GT(text(viewer, "status")["message"].get<std::string>().size(), 0u) << wrong;
  }
  EXPECT_TRUE(viewer.isOpen);
}

TEST_F(FoxgloveServerTest, SurvivesNestedValues) {
  auto viewer = connect();
  constexpr std::size_t levels = 170'000;
  std::string value;
  for (std::size_t i = 0; i < levels; ++i)
    value += R"(["]",)";  // a bracket in a string closes none
  value += '1' + std::string(levels, ']');
  viewer.send(R"({"op":"setParameters","id":"a","parameters":[{"name":"blue1.Seeing.x","value":)" +
              value + "}]}");
  EXPECT_THAT(text(viewer, "status")["message"].get<std::string>(), HasSubstr("nested too deeply"));
}

/// Each subscription gets every message.
TEST_F(FoxgloveServerTest, LimitsTheSubscriptionsOfAViewer) {
  auto viewer = connect();
  const auto channel = viewer.channels["/blue1/RobotPose"]["id"].get<std::uint32_t>();
  Json wanted = Json::array();
  for (std::uint32_t id = 0; id < 15'000; ++id)
    wanted.push_back({{"id", id}, {"channelId", channel}});
  viewer.send(Json{{"op", "subscribe"}, {"subscriptions", wanted}}.dump());
  const std::string answer = text(viewer, "status")["message"];
  EXPECT_THAT(answer, HasSubstr("4 subscriptions of channel"));
  EXPECT_THAT(answer, HasSubstr("14995 more faults"));
  EXPECT_THAT(viewer.texts, Not(Contains(::testing::Truly([&](const Json& other) {
                return other["op"] == "status" && other["message"] != answer;
              }))));
  next<RobotPose>(viewer, 3);
  std::set<std::uint32_t> served;
  std::uint64_t time = viewer.data.back().time;
  EXPECT_TRUE(waitFor(viewer, [&] { return viewer.data.back().time > time + 80'000'000; }));
  for (const auto& data : viewer.data) served.insert(data.subscription);
  EXPECT_THAT(served, ElementsAre(0, 1, 2, 3));
  viewer.send(R"({"op":"unsubscribe","subscriptionIds":[0]})");
  viewer.subscribe(20'000, "/blue1/RobotPose");
  next<RobotPose>(viewer, 20'000);
}

TEST_F(FoxgloveServerTest, KeepsOnlyNamesOfParametersThatThereAre) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer keeps what is freed";
#endif
  auto viewer = connect();
  const auto ask = [&](int from) {
    std::string names = R"("blue1.Seeing.Sharp.gain")";
    for (int i = 0; i < 8'000; ++i)
      names += R"(,"blue1.Seeing.Sharp.nothing.of.this.name.is.there.)" +
               std::to_string(from * 8'000 + i) + '"';
    viewer.send(R"({"op":"subscribeParameterUpdates","parameterNames":[)" + names + "]}");
    viewer.texts.clear();
    viewer.send(R"({"op":"getParameters","parameterNames":["blue1.Seeing.Sharp.gain"],"id":"x"})");
    EXPECT_EQ(text(viewer, "parameterValues")["parameters"].size(), 1u);  // it has come that far
  };
  for (int i = 0; i < 10; ++i) ask(i);
  const double before = residentMemory();
  for (int i = 10; i < 50; ++i) ask(i);
  EXPECT_LT(residentMemory() - before, 25) << "MB";
}

TEST_F(FoxgloveServerTest, RefusesListsThatAreTooLong) {
  auto viewer = connect();
  Json names = Json::array();
  for (int i = 0; i <= 20'000; ++i) names.push_back("a");
  viewer.send(Json{{"op", "getParameters"}, {"parameterNames", names}}.dump());
  EXPECT_EQ(text(viewer, "status")["message"],
            "client: parameterNames: has more than 20000 elements");
}

/// Many requests at once hold up neither the program nor other viewers: the program does something
/// else for nine times as long as an answer took.
TEST_F(FoxgloveServerTest, AnswersAFewRequestsAtATime) {
  auto greedy = connect(), other = connect();
  constexpr std::ptrdiff_t count = 10;
  constexpr std::chrono::milliseconds each{5};
  link->toDescribe = each;
  const auto begin = std::chrono::steady_clock::now();
  for (std::ptrdiff_t i = 0; i < count; ++i)
    greedy.send(R"({"op":"getParameters","parameterNames":[],"id":"x"})");
  const auto answers = [](const TestViewer& viewer) {
    return std::ranges::count_if(viewer.texts,
                                 [](const Json& json) { return json["op"] == "parameterValues"; });
  };
  EXPECT_TRUE(waitFor(greedy, [&] { return answers(greedy) > 0; }));
  other.send(R"({"op":"getParameters","parameterNames":[],"id":"y"})");
  EXPECT_TRUE(waitFor(other, [&] { return answers(other) == 1; }));
  EXPECT_TRUE(waitFor(greedy, [&] { return answers(greedy) == count; })) << "all in the end";
  EXPECT_GE(std::chrono::steady_clock::now() - begin, (count - 1) * 9 * each);
}

TEST_F(FoxgloveServerTest, ReportsWhoIsNotLetIn) {
  EXPECT_FALSE(TestViewer::connect(server->port(), "chat"));
  std::vector<std::string> news;
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{1};
  while (news.empty() && std::chrono::steady_clock::now() < end) news = server->takeNews();
  EXPECT_THAT(news, ElementsAre("viewer 127.0.0.1 is not let in: This is a WebSocket server of the "
                                "subprotocols foxglove.websocket.v1 and foxglove.sdk.v1."));
  EXPECT_EQ(server->refusals().at(0).count, 1u);
}

}  // namespace
}  // namespace gt
