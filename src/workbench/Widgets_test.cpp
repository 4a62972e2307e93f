#include "workbench/PlotColors.h"
#include "workbench/SheetWidget.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

/// Drags from the middle of a widget to its corner.
void drag(QWidget& widget) {
  const QPoint from = widget.rect().center();
  QTest::mousePress(&widget, Qt::LeftButton, {}, from);
  QMouseEvent move{QEvent::MouseMove, QPointF{5, 5},  widget.mapToGlobal(QPointF{5, 5}),
                   Qt::NoButton,      Qt::LeftButton, {}};
  QApplication::sendEvent(&widget, &move);
  QTest::mouseRelease(&widget, Qt::LeftButton, {}, {5, 5});
}

TEST(SheetWidget, IsDraggedOnlyWithASheet) {
  SheetWidget pages, drawing;
  pages.showPages();
  int drawn = 0;
  drawing.drawn = [&](const QPointF&, const QPointF&, bool) { ++drawn; };
  for (SheetWidget* widget : {&pages, &drawing}) {
    widget->resize(200, 100);
    widget->show();
    drag(*widget);
  }
  EXPECT_EQ(drawn, 0);
  const auto sheet = std::make_shared<const Sheet>(200, 400);
  drawing.showSheet(sheet);
  drag(drawing);
  EXPECT_EQ(drawn, 2) << "moved, and let go";
  // A page moves with the pointer, up to where it ends.
  pages.showSheet(sheet);
  const double top = pages.toSheet({0, 0}).y();
  drag(pages);
  EXPECT_GT(pages.toSheet({0, 0}).y(), top);
}

TEST(Legend, StaysInsideASmallPlot) {
  QCustomPlot plot;
  plot.legend->setVisible(true);
  keepLegendInside(plot);
  for (int i = 0; i < 6; ++i) plot.addGraph()->setName("sensors legFR");
  plot.resize(300, 160);
  plot.replot();
  plot.replot();  // with the letters' new size
  const QRect place = plot.axisRect()->rect(), legend = plot.legend->outerRect();
  EXPECT_TRUE(place.contains(legend)) << legend.height() << " of " << place.height();
  // Where there is room the letters are as large as everywhere.
  plot.resize(300, 500);
  plot.replot();
  EXPECT_EQ(QFontInfo{plot.legend->font()}.pixelSize(), QFontInfo{plot.font()}.pixelSize());
}

TEST_F(WindowTest, EachDialogFitsIntoASmallWindow) {
  constexpr QSize small{1280, 720};
  for (const DialogType& type : Dialog::types()) {
    window->arrangeAtFirst();
    window->resize(small);
    ASSERT_TRUE(window->open(type.id));
    QTest::qWait(50);
    EXPECT_LE(window->width(), small.width()) << type.id;
    EXPECT_LE(window->height(), small.height()) << type.id;
  }
}

}  // namespace
}  // namespace gt
