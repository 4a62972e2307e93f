#pragma once
#include "representations/behavior/BehaviorControlRequest.h"
#include "representations/behavior/BehaviorRequest.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/behavior/BehaviorTrace.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/LedRequest.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/behavior/PotentialFields.h"
#include "representations/behavior/SoundRequest.h"
#include "representations/behavior/TargetPoints.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/CameraSettings.h"
#include "representations/infrastructure/CeilingCameraPercept.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/JointGains.h"
#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/infrastructure/Player.h"
#include "representations/infrastructure/RobotCalibration.h"
#include "representations/infrastructure/RobotDimensions.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/ObstaclesModel.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/RobotState.h"
#include "representations/motion/GetupEngineOutput.h"
#include "representations/motion/HeadMotionRequest.h"
#include "representations/motion/JointDataSequence.h"
#include "representations/motion/KickTable.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/MotionNet.h"
#include "representations/motion/OdometryData.h"
#include "representations/motion/SpecialActionsOutput.h"
#include "representations/motion/WalkingEngineOutput.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/BodyPercept.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/CollisionPercept.h"
#include "representations/perception/ColorTable64.h"
#include "representations/perception/LandmarksPercept.h"
#include "representations/perception/LearnedCalibration.h"
#include "representations/perception/LinesPercept.h"
#include "representations/perception/ObstaclesPercept.h"
#include "representations/perception/PlayersPercept.h"
#include "representations/perception/PsdPercept.h"

namespace gt {

/// Instantiates a template with all representations: `AllRepresentations<std::tuple>`.
template <template <typename...> typename List>
using AllRepresentations =
    List<BehaviorControlRequest, BehaviorRequest, BehaviorState, BehaviorTrace, HeadControlMode,
         LedRequest, LedValue, MotionRequest, PotentialFields, SoundRequest, Speaker, TargetPoints,
         BehaviorTeamMessage, TeamMessage, TeamMessages, CameraInfo, CameraSettings,
         CeilingCameraPercept, FieldDimensions, FrameInfo, GameControlData, Image, JointData,
         JointGains, OracledWorldState, Player, RobotCalibration, RobotDimensions, SensorData,
         SensorDataBuffer, BallModel, TeamBallModel, ObstaclesModel, PlayersCollection, RobotPose,
         RobotState, GetupEngineOutput, HeadMotionRequest, JointDataSequence, KickTable, MotionInfo,
         MotionNet, OdometryData, SpecialActionsOutput, WalkingEngineOutput, BallPercept,
         BodyPercept, CameraMatrix, CollisionPercept, ColorTable64, LandmarksPercept,
         LearnedCalibration, LinesPercept, ObstaclesPercept, PlayersPercept, PsdPercept>;

}  // namespace gt
