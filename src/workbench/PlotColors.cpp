#include "workbench/PlotColors.h"

namespace gt {

void setPlotColors(QCustomPlot& plot, const QPalette& palette) {
  const QColor text = palette.color(QPalette::WindowText), base = palette.color(QPalette::Base);
  QColor faint = text;
  faint.setAlpha(40);
  plot.setBackground(base);
  for (QCPAxis* axis : {plot.xAxis, plot.yAxis, plot.yAxis2}) {
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

}  // namespace gt
