#pragma once
#include <memory>
#include <optional>
#include <string>

#include "base/TemporaryFolder.h"
#include "workbench/clicks/Hand.h"

namespace gt {

/// Does what the blocks "clicks" of a page say, sentence by sentence, in a copy of the data.
class Walk {
 public:
  /// `pictures` is the folder for the pictures that the page asks for; empty: none is written.
  explicit Walk(std::string pictures) : pictures_{std::move(pictures)} {}
  ~Walk();

  /// Throws std::runtime_error with the line that could not be done.
  void read(const std::string& page);

 private:
  struct Line {
    int number;
    QString text;
  };
  void perform(const QString& line);
  void begin(const QString& scene, const QString& seed);
  void show(const QString& name, const QString& title);
  template <typename Work>
  auto on(Work work);
  bool holds(const QString& condition);
  void finish();

  const std::string pictures_;
  TemporaryFolder folder_;
  std::unique_ptr<SessionThread> session_;
  std::unique_ptr<MainWindow> window_;
  std::unique_ptr<Hand> hand_;
  int clicks_ = 0, texts_ = 0;  ///< When they were compared last.
};

/// Saves a picture as PNG, and makes its folder.
void savePicture(const QPixmap& picture, const QString& file);

}  // namespace gt
