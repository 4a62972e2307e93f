#pragma once
#include <QElapsedTimer>
#include <functional>
#include <optional>
#include <utility>

#include "representations/infrastructure/Image.h"
#include "workbench/SessionThread.h"

namespace gt {

/// Requests images of the connected robot for a dialog, at most five a second.
class ImageSource {
 public:
  ImageSource(SessionThread& session, QObject& owner, std::function<void(Image)> taken)
      : session_{session}, owner_{owner}, taken_{std::move(taken)} {}

  /// To be called with each refresh of the dialog.
  void refresh() {
    if (asked_ || session_.version() == version_) return;
    if (clock_.isValid() && clock_.elapsed() < interval) return;
    clock_.start();
    version_ = session_.version();
    asked_ = true;
    session_.ask(
        &owner_,
        [](Console& console) -> std::optional<Image> {
          const auto first = console.firstRobot();
          if (!first) return std::nullopt;
          const auto image = (*first)->observed().value<Image>();
          if (!image || (*image)->pixels.empty()) return std::nullopt;
          return **image;
        },
        [this](std::optional<Image>& image) {
          asked_ = false;
          if (image) taken_(std::move(*image));
        });
  }

 private:
  static constexpr int interval = 200;  // ms

  SessionThread& session_;
  QObject& owner_;
  std::function<void(Image)> taken_;
  QElapsedTimer clock_;
  bool asked_ = false;
  std::uint64_t version_ = 0;
};

}  // namespace gt
