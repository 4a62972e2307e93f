#pragma once
#include <string>
#include <vector>

#include "framework/Layout.h"

namespace gt {

/// What the platform sends to a robot where it senses for itself: in a simulator or on hardware.
const std::vector<const RepresentationType*>& platformRepresentations();

/// The same and the truth (OracledWorldState): what a simulator sends to a robot that was given it.
std::vector<const RepresentationType*> representationsWithTruth();

/// What such a platform takes from the robot: its commands, and its message to its team.
const std::vector<const RepresentationType*>& commandRepresentations();

/// Whether a platform takes a type of package.
bool isCommand(const RepresentationType& type);

/// The process that sends a representation to others: the one whose task provides it. No task
/// provides CameraSettings: they come from the first process that reads images. Empty if there is
/// none.
std::string senderOf(const Plan& plan, const RepresentationType& type);

}  // namespace gt
