#include "motionnet/Compiler.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "motionnet/Listing.h"

namespace motionnet {
namespace {

using testing::HasSubstr;

const Rules twoJoints{{{"hip", -2000, 2000}, {"knee", 0, 1000}}};

const std::string entry =
    "motion_id = extern\nlabel start\n"
    "transition stand stand start\n"
    "transition kick kick start\n";
const std::string stand =
    "motion_id = stand\nlabel start\n"
    "~ 100 1 20\n"
    "transition allMotions extern start\n";
const std::string kick =
    "motion_id = kick\nlabel start\n"
    "~ 500 1 10\n"
    "label loop\n"
    "~ 900 0 2\n"
    "transition kick kick loop\n"
    "transition allMotions stand start\n";

Compilation compiled(const std::string& a, const std::string& b, const std::string& c) {
  return compile({{"kick.mof", c}, {"extern.mof", a}, {"stand.mof", b}}, twoJoints);
}

std::string firstError(const Compilation& compilation) {
  return compilation.errors.empty() ? "" : compilation.errors.front().text();
}

/// The text with one line put for another.
std::string with(std::string text, const std::string& line, const std::string& instead) {
  const auto at = text.find(line);
  EXPECT_NE(at, text.npos);
  return text.replace(at, line.size(), instead);
}

TEST(Compiler, LinksMotionsToOneNet) {
  const auto result = compiled(entry, stand, kick);
  ASSERT_TRUE(result) << firstError(result);
  const auto& net = result.net;
  ASSERT_EQ(net.motions.size(), 3u);
  EXPECT_EQ(net.motions[0], "extern");
  EXPECT_EQ(net.motions[1], "kick");
  EXPECT_EQ(net.motions[2], "stand");
  EXPECT_EQ(net.entry, 0);
  const auto& toKick = net.nodes[1];
  EXPECT_EQ(toKick.kind, Node::Kind::transition);
  EXPECT_EQ(toKick.requested, 1);
  EXPECT_EQ(net.nodes[static_cast<std::size_t>(toKick.target)].angles[1], 500);
  EXPECT_EQ(net.nodes[2].kind, Node::Kind::leave);
}

TEST(Compiler, MakesTheEntryThatNoFileDescribes) {
  const auto described = compiled(entry, with(stand, "~ 100", "~ 200"), kick);
  const auto made =
      compile({{"kick.mof", kick}, {"stand.mof", with(stand, "~ 100", "~ 200")}}, twoJoints);
  ASSERT_TRUE(described) << firstError(described);
  ASSERT_TRUE(made) << firstError(made);
  EXPECT_EQ(made.net.motions[0], "extern");
  ASSERT_EQ(made.net.nodes.size(), described.net.nodes.size());
  for (const int request : {1, 2}) {
    const auto enters = [&](const Net& net) {
      for (const auto& node : net.nodes)
        if (node.motion == 0 && node.requested == request) return node.target;
      return -1;
    };
    EXPECT_EQ(enters(made.net), enters(described.net));
  }
}

TEST(Compiler, PosturesAreKnownInAllFiles) {
  const std::string named = with(stand, "label start\n", "posture low = ~ 300\nlabel start\n");
  const auto result = compiled(entry, named, with(kick, "~ 500 1 10", "posture low 1 10"));
  ASSERT_TRUE(result) << firstError(result);
  const auto& node = result.net.nodes[static_cast<std::size_t>(result.net.nodes[1].target)];
  EXPECT_EQ(node.angles, (std::vector<std::optional<int>>{std::nullopt, 300}));
  EXPECT_EQ(node.frames, 10);
  EXPECT_EQ(firstError(compiled(entry, stand, with(kick, "~ 500 1 10", "posture low 1 10"))),
            "kick.mof:3: posture: unknown posture low");
  EXPECT_EQ(firstError(compiled(entry, named,
                                with(kick, "label start", "posture low = 1 2\nlabel start"))),
            "stand.mof:2: posture: low has another meaning already");
}

TEST(Compiler, TransitionsForAGroupServeItsMembers) {
  const auto result =
      compiled(with(entry, "label start\n", "group both = kick stand\nlabel start\n"), stand,
               with(kick, "transition allMotions stand start",
                    "transition both kick loop\ntransition extern stand start"));
  // kick never lets stand begin: found although the transition stands in a group
  EXPECT_THAT(firstError(result), HasSubstr("stand is never reached"));
}

TEST(Compiler, FindsUnknownNames) {
  EXPECT_EQ(firstError(compiled(entry, stand, with(kick, "kick loop", "kock loop"))),
            "kick.mof:6: motion: unknown motion kock");
  EXPECT_EQ(firstError(compiled(entry, stand, with(kick, "kick loop", "kick lop"))),
            "kick.mof:6: label: kick has no label lop");
  EXPECT_EQ(firstError(compiled(entry, stand, with(kick, "transition kick", "transition all"))),
            "kick.mof:6: requested: unknown motion or group all");
  EXPECT_THAT(firstError(compiled(entry, with(stand, "= stand", "= kick"), kick)),
              HasSubstr("is also the name of"));
}

TEST(Compiler, FindsMissingTransitions) {
  EXPECT_THAT(
      firstError(compiled(entry, stand, with(kick, "transition allMotions stand start\n", ""))),
      HasSubstr("kick.mof:3: transition extern: missing"));
  EXPECT_THAT(firstError(compiled(with(entry, "transition kick kick start\n", ""), stand, kick)),
              HasSubstr("extern.mof: transition kick: missing"));
  EXPECT_THAT(firstError(compiled(entry, stand, with(kick, "allMotions stand", "allMotions kick"))),
              HasSubstr("never reached from here"));
}

TEST(Compiler, FindsWhatIsNeverReached) {
  EXPECT_EQ(firstError(compiled(entry, stand + "label behind\n", kick)),
            "stand.mof:5: label: behind is the target of no transition");
  EXPECT_EQ(
      firstError(compiled(entry, stand + "~ 7 1 1\ntransition allMotions stand start\n", kick)),
      "stand.mof:5: this line is never reached");
}

TEST(Compiler, FindsLoopsWithoutData) {
  const std::string idle =
      "motion_id = kick\nlabel start\n~ 500 1 10\nlabel loop\ntransition stand kick loop\n"
      "transition allMotions extern start\n";
  EXPECT_THAT(firstError(compiled(entry, stand, idle)),
              HasSubstr("kick.mof:3: transition stand: leads into an endless loop without data"));
}

TEST(Compiler, NoInputBreaksIt) {
  std::mt19937 random{7};
  const std::string words[] = {"transition", "label", "group", "=",    "kick", "allMotions",
                               "extern",     "start", "~",     "9999", "\n",   "loop"};
  int broken = 0;
  for (int i = 0; i < 4000; ++i) {
    std::string texts[] = {entry, stand, kick};
    for (int change = 0; change <= i % 4; ++change) {
      auto& text = texts[random() % 3];
      const auto at = random() % text.size();
      switch (random() % 4) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, random() % 30);
          break;
        case 2:
          text.insert(at, " " + words[random() % std::size(words)] + " ");
          break;
        default:
          text.insert(at, text.substr(random() % text.size(), random() % 60));
      }
      if (text.empty()) text = "\n";
    }
    const auto result = compiled(texts[0], texts[1], texts[2]);
    broken += result ? 0 : 1;
    for (const auto& error : result.errors) EXPECT_FALSE(error.message.empty());
    if (!result) continue;
    for (const auto& node : result.net.nodes) {
      EXPECT_GE(node.target, 0);
      EXPECT_LT(node.target, static_cast<int>(result.net.nodes.size()));
    }
  }
  EXPECT_GT(broken, 1000);
}

TEST(Compiler, AGroupCannotBlowUpTheNet) {
  std::string many = "motion_id = kick\ngroup g =";
  for (int i = 0; i < 5000; ++i) many += " kick stand";
  many += "\nlabel start\n~ 1 1 1\n";
  for (int i = 0; i < 15000; ++i) many += "transition g kick start\n";
  EXPECT_FALSE(compiled(entry, stand, many));
}

TEST(Listing, NamesTheMotionsForXabsl) {
  const auto text = listing(compiled(entry, stand, kick).net.names());
  EXPECT_THAT(text, HasSubstr("enum special_action input {\n    none,\n    kick,\n    stand\n  }"));
  EXPECT_EQ(xabslName("getupFromBack"), "getup_from_back");
}

}  // namespace
}  // namespace motionnet
