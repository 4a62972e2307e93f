#include <QHeaderView>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "representations/behavior/TeamMessage.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "views/ViewText.h"
#include "views/Views.h"
#include "workbench/Control.h"
#include "workbench/Dialog.h"
#include "workbench/SheetWidget.h"

namespace gt {
namespace {

/// One color for each of a team's players.
constexpr Color playerColors[] = {{250, 200, 40}, {240, 90, 60}, {90, 200, 250}, {220, 130, 250}};
constexpr std::int64_t longAgo = 3000;  ///< ms; a ball that old is only a circle.

/// What one robot of the team believes and has sent and received.
struct Member {
  std::string name;
  int number = 0;
  Time now;
  RobotPose pose;
  BallModel ball;
  TeamMessage sent;
  TeamMessages received;
};

struct TeamState {
  std::shared_ptr<const Sheet> sheet{};
  std::vector<Member> members{};
  std::string fault{};
};

template <typename T>
T valueOf(ObservedRobot& robot) {
  const auto found = robot.value<T>();
  return found ? **found : T{};
}

void add(Drawing& drawing, ElementType type, std::vector<Vector2d> points, double size, Color color,
         double pen = 2, const std::string& text = {}) {
  drawing.elements.push_back({type, std::move(points), size, color, pen, text});
}

Color colorOf(int number) {
  return playerColors[static_cast<std::size_t>(std::clamp(number, 1, 4) - 1)];
}

/// Where a robot believes that it is, and where the ball.
void addBelief(Drawing& drawing, const Member& member) {
  const Pose2D& pose = member.pose.pose;
  const Color color = colorOf(member.number);
  add(drawing, ElementType::polygon,
      {pose * Vector2d{130, -60}, pose * Vector2d{130, 60}, pose * Vector2d{-130, 60},
       pose * Vector2d{-130, -60}},
      0, color);
  add(drawing, ElementType::arrow, {pose.translation, pose * Vector2d{220, 0}}, 0, color);
  add(drawing, ElementType::text, {pose.translation + Vector2d{-60, -220}}, 120, color, 1,
      std::to_string(member.number));
  if (member.ball.lastSeen == never()) return;
  const Vector2d ball = pose * member.ball.position;
  const bool fresh = member.now - member.ball.lastSeen < longAgo;
  add(drawing, fresh ? ElementType::disk : ElementType::circle, {ball}, 55, color);
  add(drawing, ElementType::circle, {ball}, std::max(55.0, member.ball.standardDeviation), color,
      1);
  add(drawing, ElementType::line, {pose.translation, ball}, 0, color, 1);
}

/// All of the team of the first selected robot that can be asked.
TeamState stateOfTeam(Console& console, const View& field) {
  ViewSubject subject = console.viewSubject();
  if (subject.robots.empty()) return {.fault = "No robot is selected."};
  const TeamColor team = gt::teamOf(*subject.robots.front());
  TeamState state;
  for (const auto& robot : console.session().robots()) {
    ObservedRobot& observed = robot->observed();
    if (observed.kind() != subject.robots.front()->kind() || gt::teamOf(observed) != team) continue;
    Member member{robot->name(),
                  0,
                  observed.time(),
                  valueOf<RobotPose>(observed),
                  valueOf<BallModel>(observed),
                  valueOf<TeamMessage>(observed),
                  valueOf<TeamMessages>(observed)};
    member.number = member.sent.playerNumber;
    state.members.push_back(std::move(member));
  }
  auto sheet = field.show(subject, {});
  if (!sheet) return {.fault = sheet.error().text()};
  Drawing drawing;
  for (const Member& member : state.members) addBelief(drawing, member);
  sheet->paint(drawing, {{sheet->width() / 2.0, sheet->height() / 2.0}, fieldViewScale, true});
  state.sheet = std::make_shared<const Sheet>(std::move(*sheet));
  return state;
}

QString secondsText(std::int64_t ms) {
  return QString{"%1 s"}.arg(static_cast<double>(ms) / 1000, 0, 'f', 1);
}

/// The beliefs of all robots of a team on one field, beside the truth, and below it the messages
/// that they have exchanged.
class TeamViewer : public Dialog {
 public:
  explicit TeamViewer(SessionThread& session) : Dialog{session} {
    auto* layout = new QVBoxLayout{this};
    layout->setContentsMargins(0, 0, 0, 0);
    auto* parts = new QSplitter{Qt::Vertical};
    layout->addWidget(parts);
    sheet_ = new SheetWidget;
    parts->addWidget(sheet_);
    table_ = makeControl<QTreeWidget>(
        "members",
        "What each robot told its team last, and how long ago it heard from each teammate");
    table_->setRootIsDecorated(false);
    table_->setHeaderLabels({"Robot", "Role", "To the ball", "Validity", "Ball seen", "Ball ±",
                             "Hears 1", "Hears 2", "Hears 3", "Hears 4"});
    table_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    constexpr int lines = 7;  // the heading, four robots, and what scrolls sideways
    table_->setMinimumHeight(lines * table_->fontMetrics().height());
    parts->addWidget(table_);
    parts->setStretchFactor(0, 3);
    parts->setStretchFactor(1, 1);
  }

  void refresh() override {
    if (supply_) return supply_->renew();
    supply_ = session().supply(
        this, [field = field_](Console& console) { return stateOfTeam(console, *field); },
        [this](const TeamState& state) { show(state); });
  }

 private:
  void show(const TeamState& state) {
    if (state.sheet)
      sheet_->showSheet(state.sheet);
    else
      sheet_->showText(QString::fromStdString(state.fault));
    while (table_->topLevelItemCount() > static_cast<int>(state.members.size()))
      delete table_->takeTopLevelItem(0);
    while (table_->topLevelItemCount() < static_cast<int>(state.members.size()))
      table_->addTopLevelItem(new QTreeWidgetItem);
    int row = 0;
    for (const Member& member : state.members) showMember(*table_->topLevelItem(row++), member);
  }
  static void showMember(QTreeWidgetItem& item, const Member& member) {
    const BehaviorTeamMessage& behavior = member.sent.behavior;
    const Color color = colorOf(member.number);
    item.setText(0, QString::fromStdString(member.name));
    QPixmap square{10, 10};
    square.fill(QColor{color.r, color.g, color.b});
    item.setIcon(0, square);
    item.setText(1, QString::fromStdString(std::string{enumName(behavior.role)}));
    constexpr double notAtAll = 1e5;  // ms
    item.setText(2, behavior.estimatedTimeToReachBall < notAtAll
                        ? secondsText(static_cast<std::int64_t>(behavior.estimatedTimeToReachBall))
                        : "–");
    item.setText(3, QString::number(member.pose.validity, 'f', 2));
    const bool seen = member.ball.lastSeen != never();
    item.setText(4, seen ? secondsText(member.now - member.ball.lastSeen) : "never");
    item.setText(5, seen ? QString{"%1 mm"}.arg(member.ball.standardDeviation, 0, 'f', 0) : "–");
    for (std::size_t i = 0; i < member.received.byPlayer.size(); ++i) {
      const Time at = member.received.byPlayer[i].timeReceived;
      const bool self = static_cast<int>(i) + 1 == member.number;
      item.setText(6 + static_cast<int>(i), self            ? ""
                                            : at == never() ? "never"
                                                            : secondsText(member.now - at));
    }
  }

  SheetWidget* sheet_;
  QTreeWidget* table_;
  std::shared_ptr<const View> field_ =
      makeFieldView("team", "", {"fieldPolygons", "fieldLines", "flags", "truth"});
  std::shared_ptr<SessionThread::Supply> supply_;
};

const RegisterDialog<TeamViewer> registeredTeamViewer{
    {.id = "team",
     .title = "Team",
     .group = "Viewers",
     .help = "Where all robots of the team believe to be and see the ball, and what they heard "
             "from each other",
     .place = DialogPlace::center}};

}  // namespace
}  // namespace gt
