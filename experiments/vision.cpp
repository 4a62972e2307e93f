// Looks at random moments of matches and compares what is found in the images with the truth.

#include <map>
#include <mutex>

#include "Experiments.h"
#include "Profiles.h"
#include "VisionMeasures.h"
#include "colors/ColorStatistics.h"
#include "colors/ColorTableFile.h"
#include "modules/perception/processors/DefaultSensorDataProcessor.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"
#include "modules/perception/processors/GridImageProcessor2.h"
#include "modules/perception/processors/GridImageProcessor3.h"
#include "modules/perception/processors/GridImageProcessorTSL.h"
#include "modules/perception/processors/LinesImageProcessor.h"

namespace gt {
namespace {

/// The colors that image processors know.
struct KnownColors {
  ColorTable64 table;    ///< The configuration's.
  ColorTable64 hand;     ///< Of HSI ranges made by hand.
  ColorTable64 learned;  ///< Of other images than those that are measured.
  TslColors tsl;
};

/// A solution of the task ImageProcessor, at work.
using Processor = std::function<void(const Image&, const CameraMatrix&, FoundPercepts&)>;
using MakeProcessor = Processor (*)(const KnownColors&);

template <typename Solution, typename... Colors>
Processor processor(const Colors&... colors) {
  struct State {
    Solution solution;
    Random random{2003};
    Debug debug{1024};
  };
  return [state = std::make_shared<State>(), &colors...](
             const Image& image, const CameraMatrix& matrix, FoundPercepts& p) {
    const auto update = [&](auto&... chance) {
      state->solution.update(image, matrix, colors..., FieldDimensions{}, p, chance...,
                             state->debug);
    };
    if constexpr (std::is_same_v<Solution, GridImageProcessor3>)
      update(state->random);
    else
      update();
  };
}
Processor gt2003(const KnownColors& colors) {
  return processor<GT2003ImageProcessor>(colors.table);
}
Processor withHandMade(const KnownColors& colors) {
  return processor<GT2003ImageProcessor>(colors.hand);
}
Processor withLearned(const KnownColors& colors) {
  return processor<GT2003ImageProcessor>(colors.learned);
}
/// Takes a lens for one that bends nothing.
Processor ignoringLens(const KnownColors& colors) {
  return [see = gt2003(colors), picture = Image{}](const Image& image, const CameraMatrix& matrix,
                                                   FoundPercepts& p) mutable {
    picture = image;
    CameraMatrix straight = matrix;
    picture.info.distortion2 = straight.info.distortion2 = 0;
    see(picture, straight, p);
  };
}
Processor grid2(const KnownColors&) {
  return processor<GridImageProcessor2>();
}
Processor grid3(const KnownColors& colors) {
  return processor<GridImageProcessor3>(colors.table);
}
Processor gridTsl(const KnownColors& colors) {
  return processor<GridImageProcessorTSL>(colors.tsl);
}
Processor lines(const KnownColors& colors) {
  return processor<LinesImageProcessor>(colors.table);
}

/// How the images of a row of the experiment differ from those of the match scene, and who looks
/// at them.
struct Condition {
  std::string name;    ///< Before the names of its figures.
  double share = 1;    ///< Of the moments that are looked at.
  bool brief = false;  ///< Only the figures that have an aim by default are measured.
  std::function<void(SceneDescription&)> change;
  MakeProcessor processor = gt2003;
};

std::vector<Condition> conditions() {
  using Scene = SceneDescription;
  const auto light = [](double brightness) {
    return [=](Scene& scene) { scene.camera.brightness = brightness; };
  };
  return {{"", 1, false, [](Scene&) {}},
          {"dark.", 1, false, light(0.75)},
          {"bright.", 1, false, light(1.25)},
          {"hard.dim.", 0.2, true, light(0.5)},
          {"hard.changing.", 0.2, true,
           [](Scene& scene) {
             scene.camera.lightChange = 0.5;
             scene.camera.lightPeriod = 3;
           }},
          {"hard.noise.", 0.2, true,
           [](Scene& scene) {
             scene.camera.noiseY = 8;
             scene.camera.noiseCb = scene.camera.noiseCr = 5;
           }},
          {"hard.motion.", 0.2, true, [](Scene& scene) { scene.camera.exposure = 20; }},
          {"hard.vignetting.", 0.2, true, [](Scene& scene) { scene.camera.vignetting = 0.5; }},
          {"hard.cast.", 0.2, true,
           [](Scene& scene) {
             scene.camera.shiftCb = -8;
             scene.camera.shiftCr = 8;
           }},
          {"hard.shadows.", 0.01, true,
           [](Scene& scene) { scene.camera.pixelShading = scene.camera.shadows = true; }},
          {"hard.audience.", 0.2, true, [](Scene& scene) { scene.audience = 60; }},
          {"hard.referees.", 0.2, true, [](Scene& scene) { scene.referees = 4; }},
          {"hard.crowd.", 0.2, true, [](Scene& scene) {
             for (int i = 0; i < 8; ++i) {
               SceneRobot robot = scene.robots[static_cast<std::size_t>(i) % scene.robots.size()];
               robot.name = "extra" + std::to_string(i);
               scene.extras.push_back(robot);
             }
           }}};
}

/// Other color tables, and another lens.
std::vector<Condition> cameraConditions() {
  const auto same = [](SceneDescription&) {};
  const auto barrel = [](SceneDescription& scene) { scene.optics.distortion2 = -0.2; };
  return {{"colors.hand.", 0.2, true, same, withHandMade},
          {"colors.learned.", 0.2, true, same, withLearned},
          {"lens.", 0.2, true, barrel, gt2003},
          {"lens.ignored.", 0.2, true, barrel, ignoringLens}};
}

/// The other image processors.
std::vector<Condition> processorConditions() {
  using Scene = SceneDescription;
  const auto same = [](Scene&) {};
  const auto dim = [](Scene& scene) { scene.camera.brightness = 0.5; };
  const auto cast = [](Scene& scene) {
    scene.camera.shiftCb = -8;
    scene.camera.shiftCr = 8;
  };
  const auto blackWhite = [](Scene& scene) {
    for (SceneBall& ball : scene.balls) ball.model = "../models/ball-black-white.xml";
  };
  // The challenge for which it was made: nobody else is on the field.
  const auto challenge = [=](Scene& scene) {
    blackWhite(scene);
    scene.robots.resize(1);
  };
  return {{"GridImageProcessor2.", 0.2, true, same, grid2},
          {"GridImageProcessor2.dim.", 0.2, true, dim, grid2},
          {"GridImageProcessor2.cast.", 0.2, true, cast, grid2},
          {"GridImageProcessorTSL.", 0.2, true, same, gridTsl},
          {"GridImageProcessorTSL.dim.", 0.2, true, dim, gridTsl},
          {"GridImageProcessor3.", 2, true, challenge, grid3},
          {"GridImageProcessor3.match.", 0.5, true, blackWhite, grid3},
          {"LinesImageProcessor.", 0.2, true, same, lines}};
}

/// What each figure should be at default.
struct AimOf {
  const char* name;
  Aim aim;
};
const std::vector<AimOf> visionAims{{"ball.found", Aim::atLeast(98)},
                                    {"ball.false", Aim::atMost(0.1)},
                                    {"ball.distance.p95", Aim::atMost(5)},
                                    {"flags.found", Aim::atLeast(97)},
                                    {"flags.false", Aim::atMost(0.1)},
                                    {"flags.bearing.p95", Aim::atMost(1)},
                                    {"goals.found", Aim::atLeast(97)},
                                    {"goals.false", Aim::atMost(0.1)},
                                    {"edges.line.right", Aim::atLeast(97)},
                                    {"edges.border.right", Aim::atLeast(97)},
                                    {"edges.yellowGoal.right", Aim::atLeast(97)},
                                    {"edges.skyblueGoal.right", Aim::atLeast(97)},
                                    {"players.found", Aim::atLeast(90)},
                                    {"players.color", Aim::atLeast(99)},
                                    {"freeGround.notOverestimated", Aim::atLeast(99)}};

/// Vision of some robots. Each has a body of its own, and learns in play how old its images are.
struct Eyes {
  Eyes(Processor processor, const DefaultSensorDataProcessor::Parameters& sensors,
       std::size_t robots)
      : sensorDataProcessors(robots), percepts(robots), imageProcessor{std::move(processor)} {
    for (auto& each : sensorDataProcessors) each.parameters = sensors;
  }

  std::vector<DefaultSensorDataProcessor> sensorDataProcessors;
  std::vector<FoundPercepts> percepts;
  Processor imageProcessor;
  CameraMatrix matrix;
  BodyPercept body;
  PsdPercept psd;
  LearnedCalibration learned;

  void look(const GameView& view, bool trueCamera) {
    FoundPercepts& found = percepts[view.robot];
    // Twice, to know how the robot walks.
    const std::array odometry{OdometryData{view.odometry * view.step.inverse()},
                              OdometryData{view.odometry}};
    for (std::size_t i = 0; i < odometry.size(); ++i)
      sensorDataProcessors[view.robot].update(
          {view.image.time - (i == 0 ? tickMs : 0)}, view.sensors, view.image, RobotDimensions{},
          RobotCalibration{}, FieldDimensions{}, MotionInfo{}, odometry[i],
          Previous<BallPercept>{found.ball}, Previous<LandmarksPercept>{found.landmarks}, matrix,
          body, psd, learned);
    if (trueCamera) matrix = view.camera;
    imageProcessor(view.image, matrix, found);
  }
};

/// What some images show of each color.
Result<ColorStatistics> lookAround(const DataRoot& root, const SceneDescription& scene) {
  constexpr std::uint64_t seed = 2003;  // Not one of those that are measured by default.
  constexpr int moments = 60;
  auto views = GameViews::make(root, scene, seed);
  if (!views) return views.error();
  ColorStatistics statistics;
  for (int i = 0; i < moments; ++i) {
    views->shuffle();
    for (std::size_t robot = 0; robot < views->world().activeRobots(); ++robot) {
      const GameView& view = views->look(robot, scene.camera);
      statistics.add(view.image, view.truth.classes);
    }
  }
  return statistics;
}

/// Thresholds in the TSL space that hold nearly all that was seen of each color.
TslColors learnTsl(const ColorStatistics& statistics) {
  constexpr double share = 0.98;
  TslColors colors = statistics.tsl(share);
  // What has a tint has it in any light.
  for (std::size_t i = 0; i < enumCount<ColorClass>; ++i) {
    const auto color = static_cast<ColorClass>(i);
    constexpr ColorSet tinted{ColorClass::orange, ColorClass::yellow, ColorClass::skyblue,
                              ColorClass::pink,   ColorClass::red,    ColorClass::blue,
                              ColorClass::green};
    ColorRange& luminance = colors.classes[color].luminance;
    if (tinted.contains(color)) luminance = {luminance[0] / 2, 255};
  }
  return colors;
}

/// Percepts of a condition compared with the truth.
Result<Tally> comparePercepts(const Condition& condition, const DataRoot& root,
                              const SceneDescription& scene, const KnownColors& colors,
                              const Job& job) {
  auto views = GameViews::make(root, scene, job.seed);
  if (!views) return views.error();
  VisionTruth truth{views->world(), views->scene()};
  VisionMeasures measures{truth};
  Tally tally;
  DefaultSensorDataProcessor::Parameters sensors;
  if (auto read = readConfig(root.path("config/modules/SensorDataProcessor.Default.cfg"), sensors);
      !read)
    return read.error();
  Eyes eyes{condition.processor(colors), sensors, views->world().activeRobots()};
  const int moments = std::max(1, static_cast<int>(job.number("moments") * condition.share));
  const bool trueCamera = job.parameter("camera") == "true";
  for (int i = 0; i < moments; ++i) {
    views->shuffle();
    // The image before tells a robot where its flags were.
    for (std::size_t robot = 0; robot < views->world().activeRobots(); ++robot)
      eyes.look(views->look(robot, scene.camera), trueCamera);
    views->waitForImage();
    for (std::size_t robot = 0; robot < views->world().activeRobots(); ++robot) {
      const GameView& view = views->look(robot, scene.camera);
      eyes.look(view, trueCamera);
      truth.look(view);
      measures.compareSensors(views->world().robot(robot), eyes.matrix, eyes.body, tally);
      measures.comparePercepts(eyes.percepts[robot], eyes.matrix, tally);
      tally.count("pictures", true);
    }
  }
  return tally;
}

/// The figures of one condition.
Measurement figuresOf(const Condition& condition, const Tally& tally) {
  Measurement measured;
  const auto add = [&](const std::string& name, const std::string& unit, double value) {
    const auto aim = std::find_if(visionAims.begin(), visionAims.end(),
                                  [&](const AimOf& of) { return name == of.name; });
    const bool ofBall = condition.processor == grid3 && name.starts_with("ball.");
    if (condition.brief && aim == visionAims.end() && !ofBall) return false;
    const bool asked = condition.name.empty() && aim != visionAims.end();
    measured.add("vision." + condition.name + name, unit, value, asked ? aim->aim : Aim{});
    return true;
  };
  const auto addRate = [&](const std::string& name, const Tally::Rate& rate) {
    if (add(name, "%", rate.percent()))
      measured.add("vision." + condition.name + name + ".n", "", rate.all);
  };
  for (const auto& [name, rate] : tally.rates)
    if (name == "pictures")
      add(name, "", rate.all);
    else
      addRate(name, rate);
  for (const auto& [name, errors] : tally.errors) {
    add(name + ".bias", errors.unit, errors.bias());
    for (const auto& [of, value] : summaryOf(errors.sizes()))
      add(name + '.' + of, errors.unit, value);
  }
  return measured;
}

Result<KnownColors> learnColors(const DataRoot& root, const SceneDescription& scene) {
  const auto table = readColorTable(root.path("config/coltable.c64"));
  if (!table) return table.error();
  const auto hand = readHsiColors(root.path("experiments/colors/hand.hsi"));
  if (!hand) return hand.error();
  const auto statistics = lookAround(root, scene);
  if (!statistics) return statistics.error();
  constexpr int growth = 4;
  return KnownColors{*table, hand->table(), statistics->table(growth), learnTsl(*statistics)};
}

/// The colors that all jobs of a profile share; `scene` is the scene as it is in that profile.
const Result<KnownColors>& knownColors(const DataRoot& root, const SceneDescription& scene) {
  static std::mutex mutex;
  static std::map<Profile, Result<KnownColors>> known;
  const std::lock_guard lock{mutex};
  const auto found = known.find(scene.profile);
  if (found != known.end()) return found->second;
  return known.emplace(scene.profile, learnColors(root, scene)).first->second;
}

std::vector<Condition> allConditions() {
  std::vector<Condition> all = conditions();
  for (Condition& condition : cameraConditions()) all.push_back(std::move(condition));
  for (Condition& condition : processorConditions()) all.push_back(std::move(condition));
  return all;
}

/// A condition's name as a parameter: without the point at its end.
std::string parameterOf(const Condition& condition) {
  return condition.name.empty() ? "match" : condition.name.substr(0, condition.name.size() - 1);
}

Result<Measurement> measureVision(const Job& job, const DataRoot& root) {
  auto scene = loadScene(job, root);
  if (!scene) return scene.error();
  const auto& colors = knownColors(root, *scene);
  if (!colors) return colors.error();
  for (const Condition& condition : allConditions()) {
    if (parameterOf(condition) != job.parameter("condition")) continue;
    condition.change(*scene);
    const auto tally = comparePercepts(condition, root, *scene, *colors, job);
    if (!tally) return tally.error();
    return figuresOf(condition, *tally);
  }
  return Measurement{};
}

}  // namespace

Experiment visionExperiment() {
  Parameter which{"condition", "scene, colors, lens or image processor", Parameter::Kind::each, {}};
  for (const Condition& condition : allConditions()) which.values.push_back(parameterOf(condition));
  return {"vision.pictures",
          "Percepts in random moments of matches against the truth",
          {profileParameter(),
           changeParameter(),
           which,
           {"moments", "each gives one image a robot", Parameter::Kind::number, {"250"}},
           {"camera",
            "the measured camera pose, or the true one",
            Parameter::Kind::choice,
            {"measured", "true"}}},
          measureVision};
}

}  // namespace gt
