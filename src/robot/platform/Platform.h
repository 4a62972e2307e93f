#pragma once
#include <string>
#include <vector>

#include "framework/Layout.h"

namespace gt {

/// The representations that a platform with its own sensors sends to a robot: a simulator or
/// hardware.
const std::vector<const RepresentationType*>& platformRepresentations();

/// Additionally contains the truth (OracledWorldState), for robots to which a simulator sends it.
std::vector<const RepresentationType*> representationsWithTruth();

/// The representations that such a platform receives from the robot: commands, and the message to
/// the team.
const std::vector<const RepresentationType*>& commandRepresentations();

/// Whether a platform receives a type of package.
bool isCommand(const RepresentationType& type);

/// The name of the process that sends a representation: the one whose task provides it.
/// CameraSettings are not provided by a task; they are sent by the first process that reads images.
/// Empty if there is none.
std::string senderOf(const Plan& plan, const RepresentationType& type);

}  // namespace gt
