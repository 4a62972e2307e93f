#pragma once
#include <array>
#include <span>
#include <string_view>

#include "base/Enum.h"
#include "simulation/scene/Scene.h"

namespace gt {

/// A number that the profiles set. docs/realism.md shows all of them.
struct ProfileNumber {
  std::string_view element, name;  ///< Of a scene; no element: the scene's own attribute.
  EnumArray<Profile, double> values;
  std::string_view source;
};

/// All numbers that the profiles set, in the order of the elements.
std::span<const ProfileNumber> profileTable();

/// Sets all numbers of a profile. A test checks that the table and the elements' fields agree.
void setProfile(SceneDescription& scene, Profile profile);

/// Calls visit(name, element) for each element of a scene that a profile sets.
template <typename Scene, typename Visit>
void forEachProfileElement(Scene& scene, const Visit& visit) {
  visit("noise", scene.noise);
  visit("body", scene.body);
  visit("walking", scene.walking);
  visit("camera", scene.camera);
  visit("physics", scene.physics);
  visit("radio", scene.radio);
}

}  // namespace gt
