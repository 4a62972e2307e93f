#include <gmock/gmock.h>

#include "support/TestFoxglove.h"

namespace gt {
namespace {

using ::testing::IsEmpty;

TEST_F(FoxgloveServerTest, GetsSetsAndFollowsParameters) {
  auto viewer = connect(), other = connect();
  other.send(R"({"op":"subscribeParameterUpdates","parameterNames":[]})");
  viewer.send(R"({"op":"getParameters","parameterNames":[],"id":"all"})");
  const Json all = text(viewer, "parameterValues");
  EXPECT_EQ(all["id"], "all");
  EXPECT_EQ(all["parameters"].dump(),
            R"([{"name":"blue1.Seeing.Sharp.gain","value":0.5,"type":"float64"},)"
            R"({"name":"blue1.Seeing.Sharp.title","value":"a b"},)"
            R"({"name":"blue1.Seeing.Sharp.weights","value":[1,2],"type":"float64_array"}])");
  viewer.texts.clear();
  viewer.send(
      R"({"op":"setParameters","parameters":[{"name":"blue1.Seeing.Sharp.gain","value":0.75}],"id":"set"})");
  EXPECT_EQ(text(viewer, "parameterValues")["parameters"][0]["value"], 0.75);
  EXPECT_EQ(link->gain, "0.75");
  EXPECT_EQ(changes, 1);
  EXPECT_EQ(text(other, "parameterValues")["parameters"][0]["value"], 0.75);
  other.texts.clear();
  link->gain = "1";  // by another tool
  EXPECT_EQ(text(other, "parameterValues")["parameters"][0]["value"], 1);
  for (const char* wrong :
       {R"({"name":"blue1.Seeing.Sharp.gain","value":"high"})",
        R"({"name":"blue1.Seeing.Sharp.gain","value":[[1]]})",
        R"({"name":"blue1.Hearing.gain","value":1})", R"({"name":"blue1","value":1})",
        R"({"name":"","value":1})", R"({"name":"red9.Seeing.Sharp.gain","value":1})"}) {
    viewer.texts.clear();
    viewer.send(std::string{R"({"op":"setParameters","parameters":[)"} + wrong + "]}");
    EXPECT_EQ(text(viewer, "status")["level"], 2) << wrong;
  }
  EXPECT_EQ(changes, 1);
}

/// What is shown can be set back as it is.
TEST_F(FoxgloveServerTest, SetsTextsAndLists) {
  auto viewer = connect();
  const auto set = [&](const std::string& name, const Json& value) {
    viewer.texts.clear();
    viewer.send(Json{{"op", "setParameters"},
                     {"id", "set"},
                     {"parameters", {{{"name", "blue1.Seeing.Sharp." + name}, {"value", value}}}}}
                    .dump());
    return text(viewer, "parameterValues")["parameters"].at(0)["value"];
  };
  for (const char* title : {"", "a b", "\"q\"", "always"}) EXPECT_EQ(set("title", title), title);
  EXPECT_EQ(link->title, "always");
  EXPECT_EQ(set("weights", {0.5, 2, 3}), Json({0.5, 2, 3}));
  EXPECT_EQ(link->weights, "0.5 2 3");
  EXPECT_EQ(set("weights", Json::array()), Json::array());
  viewer.texts.clear();
  viewer.send(R"({"op":"setParameters","parameters":[],"id":"none"})");
  const Json none = text(viewer, "parameterValues");
  EXPECT_EQ(none["id"], "none");
  EXPECT_THAT(none["parameters"], IsEmpty());
}

TEST_F(FoxgloveServerTest, SetsParametersOfRobotsThatAreNamedByTheirAddress) {
  auto* elsewhere = new SendingRobot;
  ObservedRobot other{"127.0.0.11", std::unique_ptr<RobotLink>{elsewhere}};
  subject.robots.push_back(&other);
  auto viewer = connect();
  EXPECT_TRUE(waitFor(viewer, [&] {
    other.update();
    return viewer.channels.contains("/127.0.0.11/RobotPose");
  }));
  viewer.send(
      R"({"op":"setParameters","parameters":[{"name":"127.0.0.11.Seeing.Sharp.gain","value":0.25}],"id":"set"})");
  EXPECT_TRUE(waitFor(viewer, [&] {
    other.update();
    return elsewhere->gain == "0.25";
  }));
  EXPECT_EQ(link->gain, "0.5");
  server->forget();
}

}  // namespace
}  // namespace gt
