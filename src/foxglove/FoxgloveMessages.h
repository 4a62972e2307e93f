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
    return Fields{field<&Duration::sec>(Unit::s), field<&Duration::nanosec>(Unit::ns)};
  }
};

struct Rgba {
  double r = 0, g = 0, b = 0, a = 1;

  static Rgba of(const Color& color);
  static constexpr auto fields() {
    return Fields{field<&Rgba::r>(), field<&Rgba::g>(), field<&Rgba::b>(), field<&Rgba::a>()};
  }
};

struct Point2 {
  double x = 0, y = 0;

  static constexpr auto fields() { return Fields{field<&Point2::x>(), field<&Point2::y>()}; }
};

struct Point3 {
  double x = 0, y = 0, z = 0;

  static constexpr auto fields() {
    return Fields{field<&Point3::x>(), field<&Point3::y>(), field<&Point3::z>()};
  }
};

struct Quaternion {
  double x = 0, y = 0, z = 0, w = 1;

  static constexpr auto fields() {
    return Fields{field<&Quaternion::x>(), field<&Quaternion::y>(), field<&Quaternion::z>(),
                  field<&Quaternion::w>()};
  }
};

struct SpatialPose {
  Point3 position;
  Quaternion orientation;

  /// Converts a pose from mm.
  static SpatialPose of(const Pose3D& pose);
  static constexpr auto fields() {
    return Fields{field<&SpatialPose::position>(), field<&SpatialPose::orientation>()};
  }
};

/// A cube or a sphere.
struct Solid {
  SpatialPose pose;
  Point3 size;
  Rgba color;

  static constexpr auto fields() {
    return Fields{field<&Solid::pose>(), field<&Solid::size>(), field<&Solid::color>()};
  }
};

struct Cylinder {
  SpatialPose pose;
  Point3 size;
  double bottomScale = 1, topScale = 1;
  Rgba color;

  static constexpr auto fields() {
    return Fields{field<&Cylinder::pose>(), field<&Cylinder::size>(),
                  field<&Cylinder::bottomScale>(), field<&Cylinder::topScale>(),
                  field<&Cylinder::color>()};
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
    return Fields{field<&Lines::type>(),
                  field<&Lines::pose>(),
                  field<&Lines::thickness>("pixel if it is scale invariant"),
                  field<&Lines::scaleInvariant>(),
                  field<&Lines::points>(),
                  field<&Lines::color>(),
                  field<&Lines::colors>(),
                  field<&Lines::indices>()};
  }
};

struct Triangles {
  SpatialPose pose{};
  std::vector<Point3> points{};
  Rgba color{};
  std::vector<Rgba> colors{};
  std::vector<std::uint32_t> indices{};

  static constexpr auto fields() {
    return Fields{field<&Triangles::pose>(), field<&Triangles::points>(),
                  field<&Triangles::color>(), field<&Triangles::colors>(),
                  field<&Triangles::indices>()};
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
    return Fields{field<&SpatialText::pose>(),     field<&SpatialText::billboard>(),
                  field<&SpatialText::fontSize>(), field<&SpatialText::scaleInvariant>(),
                  field<&SpatialText::color>(),    field<&SpatialText::text>()};
  }
};

/// An object in space. It stays until another one with the same id is received.
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
    return Fields{field<&SceneEntity::timestamp>(),
                  field<&SceneEntity::frameId>(),
                  field<&SceneEntity::id>(),
                  field<&SceneEntity::lifetime>(),
                  field<&SceneEntity::frameLocked>("moves with its frame"),
                  field<&SceneEntity::cubes>(),
                  field<&SceneEntity::spheres>(),
                  field<&SceneEntity::cylinders>(),
                  field<&SceneEntity::lines>(),
                  field<&SceneEntity::triangles>(),
                  field<&SceneEntity::texts>()};
  }
};

struct SceneUpdate {
  std::vector<SceneEntity> entities{};

  static Schema schema();
  static constexpr auto fields() { return Fields{field<&SceneUpdate::entities>()}; }
};

struct CircleAnnotation {
  RosTime timestamp{};
  Point2 position{};
  double diameter = 0, thickness = 1;
  Rgba fillColor{}, outlineColor{};

  static constexpr auto fields() {
    return Fields{field<&CircleAnnotation::timestamp>(),
                  field<&CircleAnnotation::position>(Unit::pixel),
                  field<&CircleAnnotation::diameter>(Unit::pixel),
                  field<&CircleAnnotation::thickness>(Unit::pixel),
                  field<&CircleAnnotation::fillColor>(),
                  field<&CircleAnnotation::outlineColor>()};
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
    return Fields{
        field<&PointsAnnotation::timestamp>(),           field<&PointsAnnotation::type>(),
        field<&PointsAnnotation::points>(Unit::pixel),   field<&PointsAnnotation::outlineColor>(),
        field<&PointsAnnotation::outlineColors>(),       field<&PointsAnnotation::fillColor>(),
        field<&PointsAnnotation::thickness>(Unit::pixel)};
  }
};

struct TextAnnotation {
  RosTime timestamp{};
  Point2 position{};
  std::string text{};
  double fontSize = 10;
  Rgba textColor{}, backgroundColor{0, 0, 0, 0};

  static constexpr auto fields() {
    return Fields{
        field<&TextAnnotation::timestamp>(), field<&TextAnnotation::position>(Unit::pixel),
        field<&TextAnnotation::text>(),      field<&TextAnnotation::fontSize>(Unit::pixel),
        field<&TextAnnotation::textColor>(), field<&TextAnnotation::backgroundColor>()};
  }
};

struct ImageAnnotations {
  std::vector<CircleAnnotation> circles{};
  std::vector<PointsAnnotation> points{};
  std::vector<TextAnnotation> texts{};

  static Schema schema();
  static constexpr auto fields() {
    return Fields{field<&ImageAnnotations::circles>(), field<&ImageAnnotations::points>(),
                  field<&ImageAnnotations::texts>()};
  }
};

struct FrameTransform {
  RosTime timestamp{};
  std::string parentFrameId{}, childFrameId{};
  Point3 translation{};
  Quaternion rotation{};

  static constexpr auto fields() {
    return Fields{field<&FrameTransform::timestamp>(), field<&FrameTransform::parentFrameId>(),
                  field<&FrameTransform::childFrameId>(), field<&FrameTransform::translation>(),
                  field<&FrameTransform::rotation>()};
  }
};

struct FrameTransforms {
  std::vector<FrameTransform> transforms{};

  static Schema schema();
  static constexpr auto fields() { return Fields{field<&FrameTransforms::transforms>()}; }
};

struct Log {
  static constexpr std::uint8_t info = 2, warning = 3, error = 4;

  RosTime timestamp{};
  std::uint8_t level = info;
  std::string message{}, name{}, file{};
  std::uint32_t line = 0;

  static Schema schema();
  static constexpr auto fields() {
    return Fields{field<&Log::timestamp>(), field<&Log::level>(), field<&Log::message>(),
                  field<&Log::name>(),      field<&Log::file>(),  field<&Log::line>()};
  }
};

/// Makes a transform from a pose in mm.
FrameTransform transformOf(Time time, std::string parent, std::string child, const Pose3D& pose);

/// A drawing on the field or around a robot (mm), in a frame of reference.
SceneEntity sceneEntity(const Drawing& drawing, Time time, std::string frame);
/// A drawing on the image.
ImageAnnotations imageAnnotations(const Drawing& drawing, Time time);

/// The field with lines, goals and flags, in the red team's coordinates.
SceneEntity fieldEntity(const FieldDimensions& field, Time time, std::string frame);

/// The true pose of a robot or ball.
struct TrueBody {
  std::string name;
  TeamColor team = TeamColor::red;  ///< Team of a robot.
  Pose3D pose{};                    ///< mm, on the field
};
SceneEntity robotEntity(const TrueBody& robot, Time time, std::string frame);
SceneEntity ballEntity(const TrueBody& ball, double radius, Time time, std::string frame);

}  // namespace gt::foxglove
