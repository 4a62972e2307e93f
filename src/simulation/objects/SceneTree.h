#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/Result.h"
#include "simulation/Simulation.h"

namespace gt {

/// All objects of a running scene (report 5.1.1); each can be listed, read and, where possible, set
/// by its path. A path leads from groups to their parts, as in `robots/red1/joints/headPan`. Values
/// are texts of numbers and words; lengths are mm, angles deg.
///
/// robots/NAME (its pose: x y angle), with joints, switches, sensors, camera, posture, …; balls/N
/// (x y, and its speed); actuators/NAME (the command, and whether the last one met nothing);
/// sensors/NAME; ceilingCamera/NAME (what it measured); emitters/NAME (0 to 1); field/NAME (x y z
/// of what stands there); game, rules, radio, noise, body,
/// walking, physics (parameters by name); profile; fidelity.
class SceneTree {
 public:
  /// The simulation must outlive the tree.
  explicit SceneTree(Simulation& simulation);

  struct Object {
    std::string path;
    std::string_view help;  ///< Describes its value.
    bool canBeSet = false;
  };

  /// All objects at and below a path, in order; all objects for an empty path.
  std::vector<Object> list(std::string_view path) const;
  /// An object's present value.
  Result<std::string> get(const std::string& path) const;
  /// Moves or switches an object. An error changes nothing.
  Result<void> set(const std::string& path, const std::string& value);

 private:
  using Numbers = std::vector<double>;
  struct Node {
    std::string_view help;
    std::function<std::string()> get;
    std::function<Result<void>(const std::string&)> set;
  };

  void add(std::string path, std::string_view help, std::function<std::string()> get,
           std::function<Result<void>(const std::string&)> set = nullptr);
  /// Adds a node that is set by `least` to `most` numbers.
  void addNumbers(const std::string& path, std::string_view help, std::function<std::string()> get,
                  std::size_t least, std::size_t most, std::function<void(const Numbers&)> set);
  /// Adds a node for a bool, a number or an enumeration: `get()` returns it, `set(value)` takes it.
  template <typename Get, typename Set = std::nullptr_t>
  void addValue(const std::string& path, std::string_view help, Get get, Set set = nullptr);
  /// Adds a node for each field of a struct.
  template <typename T>
  void addFields(const std::string& path, std::function<T()> get,
                 std::function<void(const T&)> set);
  /// Adds a node for each field of an element of the scene.
  template <typename T>
  void addElement(const std::string& path, T SceneDescription::*element);
  void addRobot(std::size_t i, const std::string& name);
  void addActiveRobot(std::size_t i, const std::string& path);
  void addBall(std::size_t i);
  void addActuators();
  void addFieldSensors();
  void addCeilingCamera();
  void addEmitters();
  void addField();
  void addGame();

  Simulation& simulation_;
  std::map<std::string, Node, std::less<>> nodes_;
};

}  // namespace gt
