#include "observer/Recorder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "debug/Drawing.h"

namespace gt {
namespace {

/// A robot that senses images and provides its setup.
class Camera : public RobotLink {
 public:
  MessageQueue& toRobot() override { return in_; }
  void exchange(const Taker& take) override {
    MessageQueue out;
    in_.handleAllMessages([&](const Message& message) {
      if (message.is<DescriptionRequest>()) {
        ProcessDescription description;
        description.process = "Eyes";
        description.representations.push_back({"Image", RepresentationOrigin::platform, true, 0});
        out.write({}, description);
      }
      if (message.is<SetupRequest>())
        out.write({}, RecordedSetup{{TeamColor::blue, PlayerRole::striker2},
                                    "",
                                    7,
                                    "cmd.layout",
                                    "GT2003.xabsl",
                                    "",
                                    {{"config/modules.cfg", {'#'}}}});
      out.write({}, answerTo(message, "Eyes", {}));
    });
    in_.clear();
    take(out);
  }

 private:
  MessageQueue in_;
};

class RecorderTest : public ::testing::Test {
 protected:
  void send(int ms, int height) {
    MessageQueue queue;
    Image image;
    image.time = Time{ms};
    image.info.width = 2;
    image.info.height = height;
    image.pixels.resize(4);
    queue.write({ms}, image);
    queue.write({ms}, Text{"seen"});
    robot.take(queue);
  }
  std::vector<std::string> topics(const std::string& path) {
    const auto log = McapReader::open(path);
    EXPECT_TRUE(log) << log.error().text();
    std::vector<std::string> names;
    for (const McapChannel& channel : log->channels())
      names.push_back(channel.topic + " " + std::to_string(channel.messageCount));
    return names;
  }

  TemporaryFolder folder;
  std::string file = (folder.path() / "logs" / "saved.mcap").string();
  ObservedRobot robot{"blue4", std::make_unique<Camera>()};
  Recorder recorder{robot};
};

TEST_F(RecorderTest, SavesWhatItTakesToReplay) {
  EXPECT_EQ(recorder.save(file).error().what, "nothing was recorded; log start begins");
  send(8, 2);
  ASSERT_TRUE(recorder.start());
  send(16, 2);
  send(24, 2000);  // this image is not whole
  send(32, 2);
  ASSERT_TRUE(recorder.save(file));
  EXPECT_THAT(topics(file),
              ::testing::UnorderedElementsAre("/input/Image 2", "/camera 2", "/Text 3"));
  const auto setup = recordedSetup(*McapReader::open(file), file);
  ASSERT_TRUE(setup) << setup.error().text();
  EXPECT_EQ(setup->player.teamColor, TeamColor::blue);
  EXPECT_EQ(setup->seed, 7u);
  EXPECT_EQ(setup->files.at(0).name, "config/modules.cfg");
}

TEST_F(RecorderTest, StopsAndForgets) {
  ASSERT_TRUE(recorder.start());
  send(8, 2);
  recorder.stop();
  send(16, 2);
  EXPECT_EQ(recorder.messages(), 3u);
  ASSERT_TRUE(recorder.start());
  send(24, 2);
  EXPECT_EQ(recorder.messages(), 6u);
  recorder.clear();
  EXPECT_EQ(recorder.messages(), 0u);
  send(32, 2);
  ASSERT_TRUE(recorder.save(file));
  EXPECT_THAT(topics(file), ::testing::Contains("/Text 1"));
}

}  // namespace
}  // namespace gt
