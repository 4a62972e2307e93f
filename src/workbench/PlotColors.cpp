#include "workbench/PlotColors.h"

#include <QFont>
#include <QFontInfo>
#include <algorithm>

namespace gt {

void setPlotColors(QCustomPlot& plot, const QPalette& palette) {
  const QColor text = palette.color(QPalette::WindowText), base = palette.color(QPalette::Base);
  QColor faint = text;
  faint.setAlpha(40);
  plot.setBackground(base);
  for (QCPAxis* axis : plot.axisRect()->axes()) {
    axis->setBasePen(QPen{text});
    axis->setTickPen(QPen{text});
    axis->setSubTickPen(QPen{text});
    axis->setTickLabelColor(text);
    axis->setLabelColor(text);
    axis->grid()->setPen(QPen{faint});
  }
  QColor cover = base;
  cover.setAlpha(200);
  plot.legend->setBrush(cover);
  plot.legend->setBorderPen(QPen{faint});
  plot.legend->setTextColor(text);
  plot.replot(QCustomPlot::rpQueuedReplot);
}

void keepLegendInside(QCustomPlot& plot) {
  plot.axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignLeft);
  QObject::connect(&plot, &QCustomPlot::beforeReplot, &plot, [&plot] {
    constexpr int smallest = 8, frame = 20, iconWidth = 24;  // pixels
    constexpr double share = 0.75;                           // of a row, for its letters
    QCPLegend& legend = *plot.legend;
    const int row = (plot.axisRect()->height() - frame) / std::max(1, legend.rowCount());
    QFont font = plot.font();
    font.setPixelSize(std::clamp(static_cast<int>(share * (row - legend.rowSpacing())), smallest,
                                 QFontInfo{font}.pixelSize()));
    if (font == legend.font()) return;
    legend.setFont(font);
    legend.setIconSize(iconWidth, font.pixelSize());
  });
}

}  // namespace gt
