#pragma once
#include <string>
#include <utility>

#include "workbench/SessionThread.h"

namespace gt {

/// Sends a value, such as a part of the configuration, to the connected robots, which use it at
/// once. The console prints it under the name `what`.
template <typename T>
void sendToRobots(SessionThread& session, T value, std::string what) {
  session.change([value = std::move(value), what = std::move(what)](Console& console) {
    console.session().match().markIrreproducible(what + " was sent by hand");
    const auto done =
        console.forEachRobot([&](ConsoleRobot& robot) { return robot.observed().send(value); });
    console.print(done ? what + " was sent." : "error: " + done.error().text());
  });
}

}  // namespace gt
