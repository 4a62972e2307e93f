#pragma once
#include <cstring>

#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/Joints.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/LandmarksPercept.h"
#include "representations/perception/ObstaclesPercept.h"
#include "representations/perception/PsdPercept.h"
#include "streams/representations.pb.h"

/// From representations to messages of Protocol Buffers, and back.
namespace gt::protobuf {

inline void set(const Vector2d& value, rival::Vector2& message) {
  message.set_x(value.x());
  message.set_y(value.y());
}
inline void get(const rival::Vector2& message, Vector2d& value) {
  value = {message.x(), message.y()};
}
inline void set(const Vector3d& value, rival::Vector3& message) {
  message.set_x(value.x());
  message.set_y(value.y());
  message.set_z(value.z());
}
inline void get(const rival::Vector3& message, Vector3d& value) {
  value = {message.x(), message.y(), message.z()};
}

inline void set(const CameraInfo& value, rival::CameraInfo& message) {
  message.set_width(value.width);
  message.set_height(value.height);
  message.set_focal_x(value.focalX);
  message.set_focal_y(value.focalY);
  message.set_center_x(value.centerX);
  message.set_center_y(value.centerY);
  message.set_row_time(value.rowTime);
  message.set_distortion2(value.distortion2);
  message.set_distortion4(value.distortion4);
}
inline void get(const rival::CameraInfo& message, CameraInfo& value) {
  value = {message.width(),    message.height(),      message.focal_x(),
           message.focal_y(),  message.center_x(),    message.center_y(),
           message.row_time(), message.distortion2(), message.distortion4()};
}

inline void set(const Image& value, rival::Image& message) {
  message.set_time(value.time.ms);
  set(value.info, *message.mutable_info());
  message.set_pixels(value.pixels.data(), value.pixels.size() * sizeof(Pixel));
}
inline void get(const rival::Image& message, Image& value) {
  value.time.ms = message.time();
  get(message.info(), value.info);
  value.pixels.resize(message.pixels().size() / sizeof(Pixel));
  std::memcpy(value.pixels.data(), message.pixels().data(), value.pixels.size() * sizeof(Pixel));
}

inline void set(const ConditionalBoundary& value, rival::ConditionalBoundary& message) {
  message.set_left(value.left);
  message.set_right(value.right);
  message.set_top(value.top);
  message.set_bottom(value.bottom);
  message.set_left_on_border(value.leftOnBorder);
  message.set_right_on_border(value.rightOnBorder);
  message.set_top_on_border(value.topOnBorder);
  message.set_bottom_on_border(value.bottomOnBorder);
}
inline void get(const rival::ConditionalBoundary& message, ConditionalBoundary& value) {
  value = {message.left(),          message.right(),           message.top(),
           message.bottom(),        message.left_on_border(),  message.right_on_border(),
           message.top_on_border(), message.bottom_on_border()};
}

template <typename Percept>
void setLandmark(const Percept& value, int kind, rival::Landmark& message) {
  message.set_kind(kind);
  set(value.boundary, *message.mutable_boundary());
  message.set_distance(value.distance);
  message.set_angle(value.angle);
}
template <typename Percept>
void getLandmark(const rival::Landmark& message, Percept& value) {
  get(message.boundary(), value.boundary);
  value.distance = message.distance();
  value.angle = message.angle();
}

inline void set(const LandmarksPercept& value, rival::LandmarksPercept& message) {
  message.set_time(value.time.ms);
  set(value.cameraOffset, *message.mutable_camera_offset());
  message.set_number_of_flags(value.numberOfFlags);
  message.clear_flags();
  for (const FlagPercept& flag : value.flags)
    setLandmark(flag, static_cast<int>(flag.type), *message.add_flags());
  message.set_number_of_goals(value.numberOfGoals);
  message.clear_goals();
  for (const GoalPercept& goal : value.goals)
    setLandmark(goal, static_cast<int>(goal.color), *message.add_goals());
}
inline void get(const rival::LandmarksPercept& message, LandmarksPercept& value) {
  value.time.ms = message.time();
  get(message.camera_offset(), value.cameraOffset);
  value.numberOfFlags = message.number_of_flags();
  for (std::size_t i = 0; i < value.flags.size(); ++i) {
    const rival::Landmark& flag = message.flags(static_cast<int>(i));
    value.flags[i].type = static_cast<FlagType>(flag.kind());
    getLandmark(flag, value.flags[i]);
  }
  value.numberOfGoals = message.number_of_goals();
  for (std::size_t i = 0; i < value.goals.size(); ++i) {
    const rival::Landmark& goal = message.goals(static_cast<int>(i));
    value.goals[i].color = static_cast<GoalColor>(goal.kind());
    getLandmark(goal, value.goals[i]);
  }
}

inline void set(const BallPercept& value, rival::BallPercept& message) {
  message.set_time(value.time.ms);
  message.set_seen(value.seen);
  set(value.offset, *message.mutable_offset());
  set(value.angle, *message.mutable_angle());
  message.set_distance_by_projection(value.distanceByProjection);
  message.set_distance_by_size(value.distanceBySize);
  set(value.centerInImage, *message.mutable_center_in_image());
  message.set_radius_in_image(value.radiusInImage);
}
inline void get(const rival::BallPercept& message, BallPercept& value) {
  value.time.ms = message.time();
  value.seen = message.seen();
  get(message.offset(), value.offset);
  get(message.angle(), value.angle);
  value.distanceByProjection = message.distance_by_projection();
  value.distanceBySize = message.distance_by_size();
  get(message.center_in_image(), value.centerInImage);
  value.radiusInImage = message.radius_in_image();
}

inline void set(const PsdPercept& value, rival::PsdPercept& message) {
  message.set_time(value.time.ms);
  set(value.offset, *message.mutable_offset());
  message.set_too_far_away(value.tooFarAway);
}
inline void get(const rival::PsdPercept& message, PsdPercept& value) {
  value.time.ms = message.time();
  get(message.offset(), value.offset);
  value.tooFarAway = message.too_far_away();
}

inline void set(const ObstaclesPercept& value, rival::ObstaclesPercept& message) {
  message.set_time(value.time.ms);
  message.clear_lines();
  for (const FreeGround& line : value.lines) {
    rival::FreeGround& to = *message.add_lines();
    set(line.nearPoint, *to.mutable_near_point());
    set(line.farPoint, *to.mutable_far_point());
    to.set_far_on_border(line.farOnBorder);
  }
}
inline void get(const rival::ObstaclesPercept& message, ObstaclesPercept& value) {
  value.time.ms = message.time();
  value.lines.resize(static_cast<std::size_t>(message.lines_size()));
  for (std::size_t i = 0; i < value.lines.size(); ++i) {
    const rival::FreeGround& line = message.lines(static_cast<int>(i));
    get(line.near_point(), value.lines[i].nearPoint);
    get(line.far_point(), value.lines[i].farPoint);
    value.lines[i].farOnBorder = line.far_on_border();
  }
}

inline void set(const JointData& value, rival::JointData& message) {
  message.mutable_angles()->Assign(value.angles.begin(), value.angles.end());
}
inline void get(const rival::JointData& message, JointData& value) {
  for (std::size_t i = 0; i < value.angles.size(); ++i)
    value.angles.values[i] = message.angles(static_cast<int>(i));
}

}  // namespace gt::protobuf
