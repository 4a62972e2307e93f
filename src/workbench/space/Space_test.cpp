#include <cmath>

#include "workbench/TestWindow.h"
#include "workbench/space/SpaceDialog.h"

namespace gt {
namespace {

/// Where a point of the field is seen in a view: a second computation, the other way round.
QPointF seenAt(const GlView& view, const OrbitCamera& camera, const Vector3d& point) {
  const Vector3d by = point - camera.from();
  const Vector3d right = camera.ahead().cross(camera.up());
  const double scale =
      view.height() / (2 * std::tan(fromDegrees(camera.openingAngle) / 2) * by.dot(camera.ahead()));
  return {view.width() / 2.0 + scale * by.dot(right),
          view.height() / 2.0 - scale * by.dot(camera.up())};
}

TEST(OrbitCamera, RaysGoThroughPointsOfTheImage) {
  OrbitCamera camera{.at = {100, 200, 30}, .azimuth = 40, .elevation = 30, .distance = 1000};
  EXPECT_NEAR((camera.from() - camera.at).norm(), 1000, 1e-9);
  const Ray center = camera.ray(0, 0, 1.5);
  EXPECT_NEAR((center.from + 1000 * center.direction - camera.at).norm(), 0, 1e-9);
  const auto ground = center.atHeight(30);
  ASSERT_TRUE(ground);
  EXPECT_NEAR((*ground - camera.at).norm(), 0, 1e-9);
  EXPECT_FALSE(camera.ray(0, 1, 1.5).atHeight(900));
  // The upper edge is half the opening angle above the center.
  EXPECT_NEAR(std::acos(center.direction.dot(camera.ray(0, 1, 1.5).direction)),
              fromDegrees(camera.openingAngle / 2), 1e-9);
  OrbitCamera restored;
  restored.restore(camera.settings());
  EXPECT_NEAR((restored.from() - camera.from()).norm(), 0, 1e-9);
}

class SpaceTest : public WindowTest {
 protected:
  SpaceTest() : WindowTest{"scenes/match.scene"} {
    window->resize(1100, 800);
    EXPECT_TRUE(execute("run 400 ms"));
  }

  /// Opens a dialog of its own window, and waits until it has drawn.
  SpaceDialog& show(const QString& id) {
    auto* dialog = dynamic_cast<SpaceDialog*>(window->open(id));
    EXPECT_TRUE(dialog) << id.toStdString();
    static_cast<QDockWidget*>(dialog->parentWidget())->setFloating(true);
    dialog->parentWidget()->resize(700, 520);
    dialog->setRobot("red1");
    EXPECT_TRUE(until([&] { return dialog->view().scene() != nullptr; }));
    EXPECT_TRUE(drawn(*dialog));
    return *dialog;
  }
  /// Waits until what is known now is drawn.
  bool drawn(SpaceDialog& dialog) {
    finish();
    // Time stands: what was asked for before comes, and then nothing more.
    auto before = dialog.view().scene();
    do {
      before = dialog.view().scene();
      QTest::qWait(200);
    } while (dialog.view().scene() != before);
    EXPECT_TRUE(execute("step"));
    return until([&] { return dialog.view().scene() != before; });
  }
  Vector3d place(const std::string& of, double height) {
    return {std::stod(value(of + ".x")), std::stod(value(of + ".y")), height};
  }
  void drag(GlView& view, const QPointF& from, const QPointF& to, Qt::KeyboardModifiers keys = {}) {
    QTest::mousePress(&view, Qt::LeftButton, keys, from.toPoint());
    finish();
    QTest::qWait(50);
    for (int i = 1; i <= 4; ++i) {
      QTest::mouseMove(&view, (from + (to - from) * i / 4).toPoint());
      QTest::qWait(30);
    }
    QTest::mouseRelease(&view, Qt::LeftButton, {}, to.toPoint());
    finish();
  }
};

TEST_F(SpaceTest, TheBallIsSeenAndDraggedAlongTheGround) {
  ASSERT_TRUE(execute("place ball 300 -600"));
  SpaceDialog& scene = show("scene");
  GlView& view = scene.view();
  const QPointF from = seenAt(view, view.camera(), {300, -600, 43});
  const QColor seen = view.grabFramebuffer().pixelColor(from.toPoint());
  EXPECT_GT(seen.red(), seen.green() + 30) << seen.name().toStdString();
  EXPECT_GT(seen.green(), seen.blue() + 20) << seen.name().toStdString();
  const auto picked = view.pick(from);
  ASSERT_TRUE(picked);
  EXPECT_LT((picked->point - Vector3d{300, -600, 43}).norm(), 60);
  const QPointF to = seenAt(view, view.camera(), {-500, -900, picked->point.z()});
  drag(view, from, to);
  const Vector3d ball = place("ball", 0);
  EXPECT_NEAR(ball.x(), -500, 40);
  EXPECT_NEAR(ball.y(), -900, 40);
  // Dragging the empty field turns the camera instead.
  const double azimuth = view.camera().azimuth;
  drag(view, {20, view.height() - 20.0}, {120, view.height() - 20.0});
  EXPECT_NE(view.camera().azimuth, azimuth);
  EXPECT_NEAR(place("ball", 0).x(), -500, 40);
}

TEST_F(SpaceTest, TheBallIsThrownWithShift) {
  ASSERT_TRUE(execute("place ball 300 -600"));
  SpaceDialog& scene = show("scene");
  GlView& view = scene.view();
  const QPointF from = seenAt(view, view.camera(), {300, -600, 43});
  const auto picked = view.pick(from);
  ASSERT_TRUE(picked);
  const QPointF to = seenAt(view, view.camera(), {-300, -600, picked->point.z()});
  const auto ball = [&] {
    return on([](Console& console) { return console.session().simulation().world().ball(0); });
  };
  // It has the speed of the mouse, over the moment before it was let go. A hand that was held up
  // tries again.
  Vector2d speed = Vector2d::Zero();
  for (int tries = 0; tries < 20 && speed.x() > -300; ++tries) {
    ASSERT_TRUE(execute("place ball 300 -600"));
    EXPECT_TRUE(drawn(scene));
    QTest::mousePress(&view, Qt::LeftButton, {}, from.toPoint());
    finish();
    QTest::qWait(50);
    QTest::mouseMove(&view, (from + (to - from) / 4).toPoint());
    QTest::qWait(40);
    QTest::mouseRelease(&view, Qt::LeftButton, Qt::ShiftModifier, to.toPoint());
    finish();
    speed = ball().speed;
  }
  EXPECT_LT(speed.x(), -300);
  EXPECT_LT(std::abs(speed.y()), 0.2 * std::abs(speed.x()));
  ASSERT_TRUE(execute("run 200 ms"));
  EXPECT_LT(ball().position.x(), -300 - 40);
  // Without Shift it stays where it is let go.
  ASSERT_TRUE(execute("place ball 300 -600"));
  EXPECT_TRUE(drawn(scene));
  drag(view, from, to);
  EXPECT_EQ(ball().speed.norm(), 0);
}

TEST_F(SpaceTest, ScenesAreDrawnInTheWindowAndFloating) {
  ASSERT_TRUE(execute("place ball 300 -600"));
  SpaceDialog& scene = show("scene");
  GlView& view = scene.view();
  auto* const dock = static_cast<QDockWidget*>(scene.parentWidget());
  for (const bool floating : {false, true, false}) {
    dock->setFloating(floating);
    window->bringToFront(scene.objectName());
    EXPECT_TRUE(drawn(scene));
    EXPECT_TRUE(view.isValid());
    const QPointF place = seenAt(view, view.camera(), {300, -600, 43});
    const QColor seen = view.grabFramebuffer().pixelColor(place.toPoint());
    EXPECT_GT(seen.red(), seen.green() + 30) << floating << " " << seen.name().toStdString();
    // What the window shows is the same.
    const QColor shown = dock->grab().toImage().pixelColor(view.mapTo(dock, place.toPoint()));
    EXPECT_GT(shown.red(), shown.green() + 30) << floating << " " << shown.name().toStdString();
  }
}

TEST_F(SpaceTest, RobotsAreDraggedBetweenTheirForelegsAndTurnedBetweenTheirHindLegs) {
  ASSERT_TRUE(execute("place red1 -300 -800 0"));
  SpaceDialog& scene = show("scene");
  GlView& view = scene.view();
  const auto pose = [&] {
    return on(
        [](Console& console) { return console.session().simulation().world().robot(0).pose; });
  };
  view.camera() = {.azimuth = -90, .elevation = 60, .distance = 2500};
  const QPointF front = seenAt(view, view.camera(), {-255, -800, 195});
  drag(view, front, seenAt(view, view.camera(), {145, -500, 195}));
  EXPECT_NEAR(pose().translation.x(), 100, 60);
  EXPECT_NEAR(pose().translation.y(), -500, 60);
  EXPECT_NEAR(pose().rotation, 0, 0.03);
  EXPECT_TRUE(drawn(scene));
  const Vector2d forelegs = pose() * Vector2d{75, 0};
  const Vector2d hind = pose() * Vector2d{-60, 0};
  drag(view, seenAt(view, view.camera(), {hind.x(), hind.y(), 205}),
       seenAt(view, view.camera(), {forelegs.x(), forelegs.y() - 135, 205}));
  EXPECT_NEAR(pose().rotation, pi / 2, 0.15);
  EXPECT_LT((pose() * Vector2d{75, 0} - forelegs).norm(), 15);
}

TEST_F(SpaceTest, SceneHasWireFramesPartsAndBeliefs) {
  SpaceDialog& scene = show("scene");
  GlView& view = scene.view();
  const int geoms = view.scene()->geoms().ngeom;
  const QImage before = view.grabFramebuffer();
  QJsonObject settings = scene.settings();
  settings["beliefs"] = true;
  scene.restore(settings);
  EXPECT_TRUE(drawn(scene));
  // A ghost has as many geoms as the robot, and there may be a ball.
  const int robot = on([](Console& console) {
    const RobotParts& parts = console.session().simulation().world().parts(0);
    return parts.lastGeom - parts.firstGeom;
  });
  EXPECT_GE(view.scene()->geoms().ngeom, geoms + robot - 1);
  settings["beliefs"] = false;
  settings["robots"] = false;
  scene.restore(settings);
  EXPECT_TRUE(drawn(scene));
  EXPECT_LE(view.scene()->geoms().ngeom, geoms - robot);
  settings["robots"] = settings["wireFrames"] = true;
  scene.restore(settings);
  EXPECT_TRUE(drawn(scene));
  EXPECT_NE(view.grabFramebuffer(), before);
  EXPECT_TRUE(view.scene()->geoms().flags[mjRND_WIREFRAME]);
}

TEST_F(SpaceTest, ARobotsSwitchesAreClickedAndADoubleClickThrowsIt) {
  SpaceDialog& robot = show("robot");
  GlView& view = robot.view();
  const auto pressed = [&] {
    return on([](Console& console) {
      return console.session().simulation().sensors(0).isPressed(Switch::back);
    });
  };
  const QPointF back = seenAt(view, view.camera(), {-10, 0, 220});
  for (const bool wanted : {true, false}) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, back.toPoint());
    EXPECT_TRUE(until([&] { return pressed() == wanted; })) << wanted;
    QTest::qWait(QApplication::doubleClickInterval() + 50);
  }
  const auto stands = [&] {
    return on([](Console& console) {
      return console.session().simulation().world().robot(0).posture == Posture::standing;
    });
  };
  const int geoms = view.scene()->geoms().ngeom;
  QTest::mouseClick(&view, Qt::LeftButton, {}, back.toPoint());
  QTest::mouseDClick(&view, Qt::LeftButton, {}, back.toPoint());
  EXPECT_TRUE(until([&] { return !stands(); }));
  EXPECT_FALSE(pressed());
  // Its tricot vanishes while it lies.
  EXPECT_TRUE(drawn(robot));
  EXPECT_LT(view.scene()->geoms().ngeom, geoms);
  QTest::mouseDClick(&view, Qt::LeftButton, {}, back.toPoint());
  EXPECT_TRUE(until([&] { return stands(); }));
}

TEST_F(SpaceTest, PerceptsAndColorsAreShownInSpace) {
  ASSERT_TRUE(execute("place red1 -600 0 0"));
  ASSERT_TRUE(execute("place ball 0 0"));
  ASSERT_TRUE(execute("run 1s"));
  SpaceDialog& radar = show("radar3D");
  // More than the ground and the robot: the image alone has more than 1000 boxes.
  EXPECT_GT(radar.view().scene()->geoms().ngeom, 1000);
  SpaceDialog& colors = show("colorSpace3D");
  const int ofImage = colors.view().scene()->geoms().ngeom;
  EXPECT_GT(ofImage, 50);
  QJsonObject settings = colors.settings();
  settings["kind"] = 1;
  colors.restore(settings);
  EXPECT_TRUE(drawn(colors));
  EXPECT_NE(colors.view().scene()->geoms().ngeom, ofImage);
  EXPECT_GT(colors.view().scene()->geoms().ngeom, 500);
  settings["kind"] = 2;
  colors.restore(settings);
  EXPECT_TRUE(drawn(colors));
  // A column for each 4 x 4 pixels.
  EXPECT_EQ(colors.view().scene()->geoms().ngeom, 44 * 36);
}

TEST_F(SpaceTest, ViewsStayWhenTheSessionBeginsAnew) {
  // It was in the window before, so that it has a second context of OpenGL now.
  SpaceDialog& scene = show("scene");
  const auto model = scene.view().scene()->model();
  ASSERT_TRUE(execute("scene one-robot"));
  EXPECT_TRUE(drawn(scene));
  EXPECT_NE(scene.view().scene()->model(), model);
  EXPECT_FALSE(scene.view().grabFramebuffer().isNull());
  EXPECT_TRUE(window->arrange(window->arrangement()));
}

TEST_F(SpaceTest, AFrameOfTheFieldIsDrawnQuickly) {
  SpaceDialog& scene = show("scene");
  scene.parentWidget()->resize(800, 600);
  QTest::qWait(200);
  constexpr int frames = 20;
  QElapsedTimer clock;
  clock.start();
  for (int i = 0; i < frames; ++i) static_cast<void>(scene.view().grabFramebuffer());
  std::printf("scene in space: %.1f ms a frame\n", static_cast<double>(clock.elapsed()) / frames);
  EXPECT_LT(clock.elapsed(), frames * 1000);
}

}  // namespace
}  // namespace gt

int main(int argc, char** argv) {
  QApplication application{argc, argv};
  testing::InitGoogleMock(&argc, argv);
  if (!gt::GlView::works()) {
    std::fprintf(stderr, "this display has no OpenGL\n");
    return 1;
  }
  return RUN_ALL_TESTS();
}
