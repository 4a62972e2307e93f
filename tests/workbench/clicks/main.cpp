#include <QApplication>
#include <exception>
#include <filesystem>

#include "commandline/CommandLine.h"
#include "workbench/clicks/DialogPictures.h"
#include "workbench/clicks/Walk.h"

/// Uses the workbench as a person does: does what a page says, or shows each dialog; takes pictures
/// of that.
int main(int argc, char** argv) {
  gt::CommandLine line{argc, argv, "Uses the workbench by clicks and keys, and takes pictures"};
  QApplication application{argc, argv};
  std::string page, pictures;
  const auto guarded = [](auto work) {
    return [work]() -> gt::Result<void> {
      try {
        return work();
      } catch (const std::exception& fault) {
        return gt::Error{.what = fault.what()};
      }
    };
  };
  const auto walk = [&]() -> gt::Result<void> {
    if (!pictures.empty()) pictures = std::filesystem::absolute(pictures).string();
    gt::Walk{pictures}.read(page);
    return {};
  };
  CLI::App& pages = line.command("page", "Does what a page's blocks of clicks say", guarded(walk));
  pages.add_option("page", page, "Page with blocks of clicks")->required();
  pages.add_option("--pictures", pictures, "Folder for the pictures of its steps");
  gt::DialogPictures options;
  options.root = line.root();
  options.settings = options.root.path("tests/workbench/clicks/dialogs.json");
  CLI::App& dialogs = line.command("dialogs", "Takes a picture of each dialog",
                                   guarded([&] { return gt::takePictures(options); }));
  dialogs.add_option("--out", options.out, "Folder for pictures of the window with each dialog")
      ->capture_default_str();
  dialogs.add_option("--dialogs", options.dialogs,
                     "Folder for a picture of each dialog alone, in a light window");
  dialogs.add_option("--only", options.only, "One dialog, by its name in layouts");
  return line.run();
}
