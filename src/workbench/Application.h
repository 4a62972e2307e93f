#pragma once
#include <QApplication>
#include <optional>
#include <utility>

#include "base/Result.h"

namespace gt {

/// The application of a window. An exception that leaves a handler ends the event loop, since Qt
/// cannot pass it on.
class Application : public QApplication {
 public:
  using QApplication::QApplication;

  bool notify(QObject* receiver, QEvent* event) override;
  /// Returns once the error that has ended the event loop; empty if there is none.
  std::optional<Error> takeFailure() { return std::exchange(failure_, std::nullopt); }

 private:
  std::optional<Error> failure_;
};

}  // namespace gt
