#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/Geometry.h"
#include "debug/Drawing.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "streams/Schema.h"

/// Messages of Foxglove's public schemas (foxglove_msgs of ROS 2), as far as this project fills
/// them in. Lengths are m, colors from 0 to 1.
namespace gt::foxglove {

struct Duration {
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;

  static constexpr auto fields() {
    return Fields{field("sec", &Duration::sec, "s"), field("nanosec", &Duration::nanosec, "ns")};
  }
};

struct Rgba {
  double r = 0, g = 0, b = 0, a = 1;

  static Rgba of(const Color& color);
  static constexpr auto fields() {
    return Fields{field("r", &Rgba::r), field("g", &Rgba::g), field("b", &Rgba::b),
                  field("a", &Rgba::a)};
  }
};

struct Point2 {
  double x = 0, y = 0;

  static constexpr auto fields() { return Fields{field("x", &Point2::x), field("y", &Point2::y)}; }
};

struct Point3 {
  double x = 0, y = 0, z = 0;

  static constexpr auto fields() {
    return Fields{field("x", &Point3::x), field("y", &Point3::y), field("z", &Point3::z)};
  }
};

struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;

  static constexpr auto fields() {
    return Fields{field("x", &Quaternion::x), field("y", &Quaternion::y),
                  field("z", &Quaternion::z), field("w", &Quaternion::w)};
  }
};

struct SpatialPose {
  Point3 position;
  Quaternion orientation;

  /// From mm.
  static SpatialPose of(const Pose3D& pose);
  static constexpr auto fields() {
    return Fields{field("position", &SpatialPose::position),
                  field("orientation", &SpatialPose::orientation)};
  }
};

/// A cube or a sphere.
struct Solid {
  SpatialPose pose;
  Point3 size;
  Rgba color;

  static constexpr auto fields() {
    return Fields{field("pose", &Solid::pose), field("size", &Solid::size),
                  field("color", &Solid::color)};
  }
};

struct Cylinder {
  SpatialPose pose;
  Point3 size;
  double bottomScale = 1, topScale = 1;
  Rgba color;

  static constexpr auto fields() {
    return Fields{field("pose", &Cylinder::pose), field("size", &Cylinder::size),
                  field("bottomScale", &Cylinder::bottomScale),
                  field("topScale", &Cylinder::topScale), field("color", &Cylinder::color)};
  }
};

struct Lines {
  static constexpr std::uint8_t strip = 0, loop = 1, list = 2;

  std::uint8_t type = list;
  SpatialPose pose{};
  double thickness = 1;
  bool scaleInvariant = true;
  std::vector<Point3> points{};
  Rgba color{};
  std::vector<Rgba> colors{};
  std::vector<std::uint32_t> indices{};

  static constexpr auto fields() {
    return Fields{field("type", &Lines::type),
                  field("pose", &Lines::pose),
                  field("thickness", &Lines::thickness, "", "pixel if it is scale invariant"),
                  field("scaleInvariant", &Lines::scaleInvariant),
                  field("points", &Lines::points),
                  field("color", &Lines::color),
                  field("colors", &Lines::colors),
                  field("indices", &Lines::indices)};
  }
};

struct Triangles {
  SpatialPose pose{};
  std::vector<Point3> points{};
  Rgba color{};
  std::vector<Rgba> colors{};
  std::vector<std::uint32_t> indices{};

  static constexpr auto fields() {
    return Fields{field("pose", &Triangles::pose), field("points", &Triangles::points),
                  field("color", &Triangles::color), field("colors", &Triangles::colors),
                  field("indices", &Triangles::indices)};
  }
};

struct SpatialText {
  SpatialPose pose{};
  bool billboard = true;
  double fontSize = 0.1;
  bool scaleInvariant = false;
  Rgba color{};
  std::string text{};

  static constexpr auto fields() {
    return Fields{field("pose", &SpatialText::pose),
                  field("billboard", &SpatialText::billboard),
                  field("fontSize", &SpatialText::fontSize),
                  field("scaleInvariant", &SpatialText::scaleInvariant),
                  field("color", &SpatialText::color),
                  field("text", &SpatialText::text)};
  }
};

/// Something in space; it stays until another one of its id comes.
struct SceneEntity {
  RosTime timestamp{};
  std::string frameId{}, id{};
  Duration lifetime{};
  bool frameLocked = false;
  std::vector<Solid> cubes{}, spheres{};
  std::vector<Cylinder> cylinders{};
  std::vector<Lines> lines{};
  std::vector<Triangles> triangles{};
  std::vector<SpatialText> texts{};

  static constexpr auto fields() {
    return Fields{field("timestamp", &SceneEntity::timestamp),
                  field("frameId", &SceneEntity::frameId),
                  field("id", &SceneEntity::id),
                  field("lifetime", &SceneEntity::lifetime),
                  field("frameLocked", &SceneEntity::frameLocked, "", "moves with its frame"),
                  field("cubes", &SceneEntity::cubes),
                  field("spheres", &SceneEntity::spheres),
                  field("cylinders", &SceneEntity::cylinders),
                  field("lines", &SceneEntity::lines),
                  field("triangles", &SceneEntity::triangles),
                  field("texts", &SceneEntity::texts)};
  }
};

struct SceneUpdate {
  std::vector<SceneEntity> entities{};

  static Schema schema();
  static constexpr auto fields() { return Fields{field("entities", &SceneUpdate::entities)}; }
};

struct CircleAnnotation {
  RosTime timestamp{};
  Point2 position{};
  double diameter = 0, thickness = 1;
  Rgba fillColor{}, outlineColor{};

  static constexpr auto fields() {
    return Fields{field("timestamp", &CircleAnnotation::timestamp),
                  field("position", &CircleAnnotation::position, "pixel"),
                  field("diameter", &CircleAnnotation::diameter, "pixel"),
                  field("thickness", &CircleAnnotation::thickness, "pixel"),
                  field("fillColor", &CircleAnnotation::fillColor),
                  field("outlineColor", &CircleAnnotation::outlineColor)};
  }
};

struct PointsAnnotation {
  static constexpr std::uint8_t loop = 2, strip = 3, list = 4;

  RosTime timestamp{};
  std::uint8_t type = strip;
  std::vector<Point2> points{};
  Rgba outlineColor{};
  std::vector<Rgba> outlineColors{};
  Rgba fillColor{0, 0, 0, 0};
  double thickness = 1;

  static constexpr auto fields() {
    return Fields{field("timestamp", &PointsAnnotation::timestamp),
                  field("type", &PointsAnnotation::type),
                  field("points", &PointsAnnotation::points, "pixel"),
                  field("outlineColor", &PointsAnnotation::outlineColor),
                  field("outlineColors", &PointsAnnotation::outlineColors),
                  field("fillColor", &PointsAnnotation::fillColor),
                  field("thickness", &PointsAnnotation::thickness, "pixel")};
  }
};

struct TextAnnotation {
  RosTime timestamp{};
  Point2 position{};
  std::string text{};
  double fontSize = 10;
  Rgba textColor{}, backgroundColor{0, 0, 0, 0};

  static constexpr auto fields() {
    return Fields{field("timestamp", &TextAnnotation::timestamp),
                  field("position", &TextAnnotation::position, "pixel"),
                  field("text", &TextAnnotation::text),
                  field("fontSize", &TextAnnotation::fontSize, "pixel"),
                  field("textColor", &TextAnnotation::textColor),
                  field("backgroundColor", &TextAnnotation::backgroundColor)};
  }
};

struct ImageAnnotations {
  std::vector<CircleAnnotation> circles{};
  std::vector<PointsAnnotation> points{};
  std::vector<TextAnnotation> texts{};

  static Schema schema();
  static constexpr auto fields() {
    return Fields{field("circles", &ImageAnnotations::circles),
                  field("points", &ImageAnnotations::points),
                  field("texts", &ImageAnnotations::texts)};
  }
};

struct FrameTransform {
  RosTime timestamp{};
  std::string parentFrameId{}, childFrameId{};
  Point3 translation{};
  Quaternion rotation{};

  static constexpr auto fields() {
    return Fields{field("timestamp", &FrameTransform::timestamp),
                  field("parentFrameId", &FrameTransform::parentFrameId),
                  field("childFrameId", &FrameTransform::childFrameId),
                  field("translation", &FrameTransform::translation),
                  field("rotation", &FrameTransform::rotation)};
  }
};

struct FrameTransforms {
  std::vector<FrameTransform> transforms{};

  static Schema schema();
  static constexpr auto fields() {
    return Fields{field("transforms", &FrameTransforms::transforms)};
  }
};

struct Log {
  static constexpr std::uint8_t info = 2, warning = 3, error = 4;

  RosTime timestamp{};
  std::uint8_t level = info;
  std::string message{}, name{}, file{};
  std::uint32_t line = 0;

  static Schema schema();
  static constexpr auto fields() {
    return Fields{field("timestamp", &Log::timestamp), field("level", &Log::level),
                  field("message", &Log::message),     field("name", &Log::name),
                  field("file", &Log::file),           field("line", &Log::line)};
  }
};

/// A transform from mm.
FrameTransform transformOf(Time time, std::string parent, std::string child, const Pose3D& pose);

/// A drawing on the field or around a robot (mm), in a frame of reference.
SceneEntity sceneEntity(const Drawing& drawing, Time time, std::string frame);
/// A drawing on the image.
ImageAnnotations imageAnnotations(const Drawing& drawing, Time time);

/// The field with lines, goals and flags, as the red team sees it.
SceneEntity fieldEntity(const FieldDimensions& field, Time time, std::string frame);

/// A robot or ball where it truly is.
struct TrueBody {
  std::string name;
  TeamColor team = TeamColor::red;  ///< Of robots.
  Pose3D pose{};                    ///< mm, on the field
};
SceneEntity robotEntity(const TrueBody& robot, Time time, std::string frame);
SceneEntity ballEntity(const TrueBody& ball, double radius, Time time, std::string frame);

}  // namespace gt::foxglove
