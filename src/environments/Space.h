#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace gt {

/// One number of an observation or action.
struct Component {
  std::string name;
  std::string unit;
  double low = -1, high = 1;
  std::string what;  ///< A sentence, where the name is not sufficient.
};

/// The space of one agent's observations or actions: numbers with a name each (float32), or a
/// camera image (uint8, YCbCr).
struct Space {
  std::vector<Component> components{};  ///< Empty for an image.
  std::size_t height = 0, width = 0;    ///< Of an image.

  bool isImage() const { return height > 0; }
  std::size_t count() const { return isImage() ? 3 * height * width : components.size(); }
  std::size_t bytes() const { return isImage() ? count() : count() * sizeof(float); }
  void add(std::string name, std::string unit, double low, double high, std::string what = "") {
    components.push_back({std::move(name), std::move(unit), low, high, std::move(what)});
  }
};

/// One of the terms whose sum is a reward.
struct RewardTerm {
  std::string name;
  std::string what;
};

}  // namespace gt
