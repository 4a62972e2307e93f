#include "workbench/space/OrbitCamera.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

constexpr double orbitPerPixel = 0.4;
constexpr double lowestPitch = -89, highestPitch = 89;  // degrees
constexpr double narrowest = 5, widest = 110;           // degrees

}  // namespace

std::optional<Vector3d> Ray::atHeight(double height) const {
  const double steps = (height - from.z()) / direction.z();
  if (!std::isfinite(steps) || steps <= 0) return std::nullopt;
  return from + steps * direction;
}

Vector3d OrbitCamera::from() const {
  const double a = fromDegrees(azimuth), e = fromDegrees(elevation);
  return at +
         distance * Vector3d{std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e)};
}

Vector3d OrbitCamera::up() const {
  const Vector3d right = ahead().cross(Vector3d::UnitZ()).normalized();
  return right.cross(ahead());
}

Ray OrbitCamera::ray(double x, double y, double aspect) const {
  const double half = std::tan(fromDegrees(openingAngle) / 2);
  const Vector3d right = ahead().cross(up());
  return {from(), (ahead() + half * (aspect * x * right + y * up())).normalized()};
}

void OrbitCamera::turn(double x, double y) {
  azimuth = std::remainder(azimuth - x * orbitPerPixel, 360);
  elevation = std::clamp(elevation + y * orbitPerPixel, lowestPitch, highestPitch);
}

void OrbitCamera::move(double x, double y, double height) {
  const double scale = 2 * distance * std::tan(fromDegrees(openingAngle) / 2) / height;
  const double a = fromDegrees(azimuth);
  at += scale *
        (x * Vector3d{std::sin(a), -std::cos(a), 0} + -y * Vector3d{std::cos(a), std::sin(a), 0});
}

void OrbitCamera::approach(double steps) {
  distance = std::clamp(distance * std::pow(1.15, -steps), nearest, farthest);
}

QJsonObject OrbitCamera::settings() const {
  return {{"x", at.x()},
          {"y", at.y()},
          {"z", at.z()},
          {"azimuth", azimuth},
          {"elevation", elevation},
          {"distance", distance},
          {"openingAngle", openingAngle}};
}

void OrbitCamera::restore(const QJsonObject& settings) {
  at = {settings["x"].toDouble(at.x()), settings["y"].toDouble(at.y()),
        settings["z"].toDouble(at.z())};
  azimuth = settings["azimuth"].toDouble(azimuth);
  elevation = std::clamp(settings["elevation"].toDouble(elevation), lowestPitch, highestPitch);
  distance = std::clamp(settings["distance"].toDouble(distance), nearest, farthest);
  openingAngle = std::clamp(settings["openingAngle"].toDouble(openingAngle), narrowest, widest);
}

}  // namespace gt
