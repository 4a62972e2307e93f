#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "Workplace.h"
#include "network/Network.h"

namespace gt {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(Programs, RefuseFoldersInsteadOfFiles) {
  const Workplace workplace;
  for (const std::string program :
       {"simgt play scenes", "simgt play scenes/one-robot.scene --behavior behavior",
        "replay --log scenes", "replay --log robot.log --colors scenes", "xabsl check behavior",
        "xabsl format behavior"}) {
    const Outcome outcome = workplace.run(program);
    EXPECT_EQ(outcome.status, 2) << program;
    EXPECT_EQ(messages(outcome.errors), 1) << outcome.errors;
  }
}

TEST(Programs, RefuseWrongArguments) {
  const Workplace workplace;
  for (const std::string program : {"simgt",
                                    "simgt play --bogus",
                                    "simgt play --minutes 0",
                                    "simgt play --seed many",
                                    "simgt play --threads 0",
                                    "replay --bogus",
                                    "replay robot.log",
                                    "xabsl",
                                    "xabsl check",
                                    "xabsl bogus",
                                    "motionnet",
                                    "motionnet bogus",
                                    "motionnet check a b",
                                    "gtlog",
                                    "gtlog bogus",
                                    "gtlog cut robot.log",
                                    "crashlog",
                                    "colortable",
                                    "colortable learn",
                                    "colortable learn --out out.png --moments 1",
                                    "colortable learn --log robot.log --out out.c64",
                                    "colortable filter robot.c64 out.c64 --class purple"}) {
    const Outcome outcome = workplace.run(program);
    EXPECT_EQ(outcome.status, 2) << program;
    EXPECT_NE(outcome.errors, "") << program;
  }
}

TEST(Programs, ReplayWithoutTheRealLogIsNoError) {
  const Workplace workplace;
  ASSERT_EQ(::setenv("GT_REAL", "nowhere", 1), 0);
  const Outcome outcome = workplace.run("replay");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_EQ(outcome.errors, "");
}

TEST(Programs, OfTheNetworkRefuseWrongUse) {
  const Workplace workplace;
  Network network;
  const std::string taken = (*network.listen("tcp://127.0.0.1:*"))->endpoint();
  const int port = std::stoi(taken.substr(taken.rfind(':') + 1));
  fs::create_directories(workplace.root() / "private");
  fs::permissions(workplace.root() / "private", fs::perms::owner_all);
  const std::string motion = "gtrobot-motion --sockets private --crashes crashes --robot red3 ";
  const std::string router = "router red3=ipc://private/red3.Tools ";
  for (const auto& [command, line] : std::vector<std::pair<std::string, std::string>>{
           {"router", "router: robots: there is none"},
           {"router --gm", "router: robots: there is none"},
           {"router red3=", "router: red3=: is no robot"},
           {"router 10.0.1.300", "router: 10.0.1.300: is no robot"},
           {"router red3=nowhere", "router: network: nowhere: "},
           {"router a=ipc:///x a=ipc:///y", "router: a: has the name or number of another"},
           {router + "--listen 0.0.0.0", "router: network: tcp://0.0.0.0:15301: can be reached"},
           {router + "--release --routers --listen 0.0.0.0",
            "router: network: tcp://0.0.0.0:15299: can be reached"},
           {router + "--release --join there", "router: network: there: "},
           {router + "--keys nokey", "router: nokey: there is no such file"},
           {router + "--keys config/log.cfg", "router: config/log.cfg"},
           {router + "--port " + std::to_string(port - 301), "router: network: " + taken},
           {motion + "--at Motion", "gtrobot-motion: Motion: expected PROCESS=ENDPOINT"},
           {motion + "--at Motion=there", "gtrobot-motion: network: there: expected an endpoint"},
           {motion + "--at Nobody=tcp://127.0.0.1:3", "gtrobot-motion: layouts/cmd.layout: Nobody"},
           {motion + "--at Motion=tcp://0.0.0.0:5001", "gtrobot-motion: network: tcp://0.0.0.0"},
           {motion + "--at Motion=" + taken, "gtrobot-motion: network: " + taken},
           {motion + "--keys nokey", "gtrobot-motion: nokey: there is no such file"},
           {motion + "--layout nolayout", "gtrobot-motion: nolayout: there is no such file"},
       }) {
    const Outcome outcome = workplace.run(command);
    EXPECT_EQ(outcome.status, 2) << command;
    EXPECT_THAT(outcome.errors, StartsWith(line)) << command;
    EXPECT_EQ(messages(outcome.errors), 1) << command << "\n" << outcome.errors;
  }
}

TEST(Programs, TheRouterRefusesAWrongLastTime) {
  const Workplace workplace;
  fs::create_directories(workplace.root() / "state/gt2003");
  for (const auto& [text, line] : std::vector<std::pair<std::string, std::string>>{
           {"garbage\n", "router.cfg:1: garbage"},
           {"robots red3=\n", "router: red3=: is no robot"},
           {"port 70000\n", "router.cfg:1: port"},
           {"", "router: robots: there is none"}}) {
    workplace.write("state/gt2003/router.cfg", text);
    const Outcome outcome = workplace.run("router");
    EXPECT_EQ(outcome.status, 2) << text;
    EXPECT_THAT(outcome.errors, HasSubstr(line)) << text;
    EXPECT_EQ(messages(outcome.errors), 1) << outcome.errors;
  }
}

}  // namespace
}  // namespace gt
