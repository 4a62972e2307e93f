#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/Enum.h"
#include "simulation/scene/MuJoCo.h"

namespace gt {

/// The kinds of things in a model, each of which has a row in some arrays of mjModel.
enum class ModelKind {
  body,
  joint,
  dof,
  position,  ///< Coordinates: qpos.
  geom,
  site,
  camera,
  light,
  material,
  pair,
  equality,
  tendon,
  actuator,
  sensor
};

/// A value for each kind.
template <typename T>
struct OfModelKinds {
  std::array<T, enumCount<ModelKind>> values{};

  T& operator[](ModelKind kind) { return values[static_cast<std::size_t>(kind)]; }
  const T& operator[](ModelKind kind) const { return values[static_cast<std::size_t>(kind)]; }
};

/// The rows of a model that have been taken into another one, by kind, in their order.
struct ModelRows : OfModelKinds<std::vector<int>> {
  bool has(ModelKind kind, int row) const;

  /// All rows of a model.
  static ModelRows all(const mjModel& model);
  /// A body and all that is part of it or of bodies below it.
  static ModelRows below(const mjModel& model, int body);
};

/// How many rows a model has of a kind.
int countOf(const mjModel& model, ModelKind kind);

/// The kind that corresponds to a type of MuJoCo's; empty for types that ModelRows does not hold.
std::optional<ModelKind> modelKindOf(mjtObj type);

/// Copies the numbers of a file that was compiled alone into a model that was joined from several
/// files. The file's rows stand in the joined model one behind another, from `first` on.
class NumberCopy {
 public:
  NumberCopy(const mjModel& alone, const ModelRows& rows, mjModel& joined,
             const OfModelKinds<int>& first, std::string prefix);

  /// Whether the rows stand for the same things in both models: equal names, kinds and parents.
  bool fits() const;
  /// Copies the numbers. Returns whether any number changed.
  bool copy();

 private:
  template <typename T>
  void column(ModelKind kind, T* mjModel::*array, int width, int widthAlone);
  template <typename T>
  void column(ModelKind kind, T* mjModel::*array, int width = 1) {
    column(kind, array, width, width);
  }
  template <typename T>
  bool same(ModelKind kind, T* mjModel::*array) const;
  bool sameNames(ModelKind kind, mjtObj type) const;
  bool sameParents() const;
  void copyBodies();
  void copyJoints();
  void copyShapes();
  void copyViews();
  void copyOthers();

  const mjModel& alone_;
  const ModelRows& rows_;
  mjModel& joined_;
  const OfModelKinds<int>& first_;
  std::string prefix_;
  bool changed_ = false;
};

}  // namespace gt
