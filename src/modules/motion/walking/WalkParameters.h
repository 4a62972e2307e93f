#pragma once
#include <array>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/RobotDimensions.h"
#include "streams/Reflection.h"

namespace gt {

/// The closed path of a foot, seen from its side (report, figure 3.20). In all modes the foot moves
/// from front to back on the ground; footLift is the height of the path.
enum class FootMode {
  rectangle,    ///< Straight up, ahead, straight down.
  halfEllipse,  ///< Up and ahead along half an ellipse.
  /// A whole ellipse: on the ground the foot presses the body up by half of footLift.
  ellipse,
  oval,         ///< Two straight lines, joined by half circles behind and ahead of them.
  freeFormQuad  ///< Along the sides of a quadruple, whose corners are parameters.
};

/// A walk as parameters, with the names of report 3.9.1.2. Lengths in mm; shares are those of the
/// step cycle.
struct WalkParameters {
  /// The corners of FootMode::freeFormQuad: the foot lands at the first, is lifted at the second,
  /// and returns by the third and fourth. Coordinates: x ahead, in units of half the distance on
  /// the ground; y away from the body, mm; z up, mm.
  using Quadruple = std::array<Vector3d, 4>;
  static Quadruple trapezoid() {
    return {Vector3d{1, 0, 0}, Vector3d{-1, 0, 0}, Vector3d{-0.6, 0, 15}, Vector3d{0.9, 0, 15}};
  }

  FootMode footMode = FootMode::halfEllipse;
  double foreHeight = 105, foreWidth = 82, foreCenterX = 15;
  double hindHeight = 110, hindWidth = 82, hindCenterX = -15;
  double foreFootTilt = 0.03, hindFootTilt = 0.03;
  double foreFootLift = 15, hindFootLift = 15;
  double legSpeedFactorX = 1, legSpeedFactorY = 1, legSpeedFactorR = 1;
  double maxStepSizeX = 36, maxStepSizeY = 27;
  double maxSpeedXChange = 500, maxSpeedYChange = 400, maxRotationChange = 5;
  double counterRotation = 0;
  int stepLen = 80;
  double foreGroundPhase = 0.5, hindGroundPhase = 0.5;
  double foreLiftPhase = 1. / 6, hindLiftPhase = 1. / 6;
  double foreLoweringPhase = 1. / 6, hindLoweringPhase = 1. / 6;
  EnumArray<Leg, double> legPhase{{0.5, 0, 0, 0.5}};
  double bodyShiftX = 0, bodyShiftY = 0, bodyShiftOffset = 0;
  bool holdsHead = false;
  double headTilt = 0, headPan = 0, headRoll = 0, mouth = 0;
  Quadruple foreFreeFormQuadPos = trapezoid(), hindFreeFormQuadPos = trapezoid();
  double correctionX = 1, correctionY = 1, correctionR = 1, driftX = 0, turnCenter = 0;

  /// The measured speed of a robot for a speed of its feet (mm/s, rad/s; report 3.9.1.3).
  Pose2D speedOf(const Pose2D& feet) const {
    const double turn = correctionR * (feet.rotation - counterRotation * feet.translation.y());
    return {turn, correctionX * feet.translation.x() + driftX,
            correctionY * feet.translation.y() + turnCenter * turn};
  }
  /// The speed of the feet for a speed of the robot: the inverse of speedOf.
  Pose2D feetFor(const Pose2D& speed) const {
    const double y = (speed.translation.y() - turnCenter * speed.rotation) / correctionY;
    return {speed.rotation / correctionR + counterRotation * y,
            (speed.translation.x() - driftX) / correctionX, y};
  }

  static constexpr auto fields() {
    using P = WalkParameters;
    constexpr Range shift{-50, 50};
    return Fields{
        field<&P::footMode>("path of a foot"),
        field<&P::foreHeight>(Unit::mm, "height of the shoulder above the foot ball", {50, 130}),
        field<&P::foreWidth>(Unit::mm, "distance of the foot from the body's middle", {40, 150}),
        field<&P::foreCenterX>(Unit::mm, "distance of the foot before the shoulder", {-80, 100}),
        field<&P::hindHeight>(Unit::mm, "height of the shoulder above the foot ball", {50, 140}),
        field<&P::hindWidth>(Unit::mm, "distance of the foot from the body's middle", {40, 150}),
        field<&P::hindCenterX>(Unit::mm, "distance of the foot before the shoulder", {-100, 80}),
        field<&P::foreFootTilt>(Unit::rad, "tilt of the foot's path, + front up", {-0.5, 0.5}),
        field<&P::hindFootTilt>(Unit::rad, "tilt of the foot's path, + front up", {-0.5, 0.5}),
        field<&P::foreFootLift>(Unit::mm, "height of the foot's path", {0, 60}),
        field<&P::hindFootLift>(Unit::mm, "height of the foot's path", {0, 60}),
        field<&P::legSpeedFactorX>("speed of the hind feet, as a share of the fore feet's",
                                   {0.1, 3}),
        field<&P::legSpeedFactorY>("speed of the hind feet, as a share of the fore feet's",
                                   {0.1, 3}),
        field<&P::legSpeedFactorR>("speed of the hind feet, as a share of the fore feet's",
                                   {0.1, 3}),
        field<&P::maxStepSizeX>(Unit::mm, "greatest distance of a foot from its center", {1, 80}),
        field<&P::maxStepSizeY>(Unit::mm, "greatest distance of a foot from its center", {1, 80}),
        field<&P::maxSpeedXChange>(Unit::mmPerS2, "greatest acceleration ahead and back", {1, 1e5}),
        field<&P::maxSpeedYChange>(Unit::mmPerS2, "greatest acceleration sideways", {1, 1e5}),
        field<&P::maxRotationChange>(Unit::radPerS2, "greatest acceleration of turning",
                                     {0.01, 1e3}),
        field<&P::counterRotation>(
            Unit::radPerMm,
            "turn for each mm walked sideways, against the turn that slipping makes",
            {-0.01, 0.01}),
        field<&P::stepLen>(Unit::frames, "length of one step cycle, in frames of 8 ms", {8, 400}),
        field<&P::foreGroundPhase>("share of the cycle on the ground", {0.2, 0.9}),
        field<&P::hindGroundPhase>("share of the cycle on the ground", {0.2, 0.9}),
        field<&P::foreLiftPhase>("share of the cycle for lifting", {0.001, 0.4}),
        field<&P::hindLiftPhase>("share of the cycle for lifting", {0.001, 0.4}),
        field<&P::foreLoweringPhase>("share of the cycle for lowering", {0.001, 0.4}),
        field<&P::hindLoweringPhase>("share of the cycle for lowering", {0.001, 0.4}),
        field<&P::legPhase>("share of the cycle after which the foot is lifted", {0, 1}),
        field<&P::bodyShiftX>(
            Unit::mm,
            "by which the body moves back from a lifted fore foot, and ahead from a hind one",
            shift),
        field<&P::bodyShiftY>(Unit::mm, "by which it moves sideways from a lifted foot", shift),
        field<&P::bodyShiftOffset>(
            "share of the cycle by which it does so before the foot is lifted", {-0.5, 0.5}),
        field<&P::holdsHead>("whether the walk itself turns the head and mouth"),
        field<&P::headTilt>(Unit::rad, "tilt of the head while `holdsHead`", {-1.44, 0.76}),
        field<&P::headPan>(Unit::rad, "pan of the head while `holdsHead`", {-1.57, 1.57}),
        field<&P::headRoll>(Unit::rad, "roll of the head while `holdsHead`", {-0.51, 0.51}),
        field<&P::mouth>(Unit::rad, "angle of the mouth while `holdsHead`", {-0.83, 0}),
        field<&P::foreFreeFormQuadPos>(
            "corners of a fore foot's path for freeFormQuad: x in half distances on the ground, y "
            "and z in mm"),
        field<&P::hindFreeFormQuadPos>(
            "corners of a hind foot's path for freeFormQuad: x in half distances on the ground, y "
            "and z in mm"),
        field<&P::correctionX>("measured speed ahead or back, as a share of the feet's (3.9.1.3)",
                               {0.2, 5}),
        field<&P::correctionY>("measured speed sideways, as a share of the feet's", {0.2, 5}),
        field<&P::correctionR>("measured turning speed, as a share of the feet's", {0.2, 5}),
        field<&P::driftX>(
            Unit::mmPerS,
            "measured speed ahead that steps make by themselves, also those to the side or back",
            {-100, 100}),
        field<&P::turnCenter>(
            Unit::mm,
            "by which the point about which the robot turns lies behind its middle, as measured",
            {-100, 100})};
  }
};

/// The reaction of walks to pushes and obstacles (Balance). With `yield`, `placement` and `lift` 0
/// there is none, as in the report.
struct BalanceParameters {
  double yield = 0;
  double placement = 0;
  double farthest = 40;
  double memory = 0.3;
  double threshold = 150;
  double stumble = 0.25;
  double lift = 0;

  static constexpr auto fields() {
    using P = BalanceParameters;
    return Fields{
        field<&P::yield>("share of the unexpected speed after a push that the feet follow", {0, 2}),
        field<&P::placement>(Unit::s, "shift of a landing foot per unexpected speed after a push",
                             {0, 1}),
        field<&P::farthest>(Unit::mm, "greatest shift of a landing foot after a push", {0, 80}),
        field<&P::memory>(Unit::s,
                          "time constant with which the unexpected speed after a push is forgotten",
                          {0.05, 5}),
        field<&P::threshold>(Unit::mmPerS, "unexpected speed below which a push is ignored",
                             {0, 1000}),
        field<&P::stumble>(
            Unit::rad,
            "difference from the usual lag of a leg in the air above which its foot has met an "
            "obstacle",
            {0.02, 2}),
        field<&P::lift>(Unit::mm, "additional lift of a foot that has met an obstacle", {0, 40})};
  }
};

/// The parameters of each walk type, and of the balance of all of them.
struct WalkTypes {
  double gameSpeed = 1;
  WalkParameters normal, fast, backward, dribble, turnWithBall, crawl, pace;
  BalanceParameters balance;

  const WalkParameters& operator[](WalkType type) const {
    static constexpr EnumArray<WalkType, WalkParameters WalkTypes::*> types{
        {&WalkTypes::normal, &WalkTypes::fast, &WalkTypes::backward, &WalkTypes::dribble,
         &WalkTypes::turnWithBall, &WalkTypes::crawl, &WalkTypes::pace}};
    return this->*types[type];
  }

  static constexpr auto fields() {
    return Fields{
        field<&WalkTypes::gameSpeed>(
            "factor to all requested speeds ahead and sideways, to play in slow motion (report "
            "J.2.6)",
            {0.1, 1}),
        field<&WalkTypes::normal>(),
        field<&WalkTypes::fast>(),
        field<&WalkTypes::backward>(),
        field<&WalkTypes::dribble>(),
        field<&WalkTypes::turnWithBall>(),
        field<&WalkTypes::crawl>(),
        field<&WalkTypes::pace>(),
        field<&WalkTypes::balance>("reaction of all walk types to pushes and obstacles")};
  }
};

}  // namespace gt
