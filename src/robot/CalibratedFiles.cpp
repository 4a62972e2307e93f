#include "robot/CalibratedFiles.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/Lines.h"
#include "robot/ProjectVersion.h"
#include "streams/Config.h"

namespace gt {

namespace fs = std::filesystem;

namespace {

constexpr auto listName = "config/calibrated.cfg";

std::string pathOf(const std::string& root, const std::string& name) {
  return (fs::path{root} / name).lexically_normal().string();
}

/// Tests, pages, and files of the build change nothing of what is calibrated.
bool isNoSource(const fs::path& file) {
  return file.filename() == "CMakeLists.txt" || file.extension() == ".md" ||
         file.stem().string().ends_with("_test");
}

Result<std::string> fingerprintOf(const std::string& root, const std::string& name) {
  const std::string path = pathOf(root, name);
  std::vector<fs::path> files{path};
  if (fs::is_directory(path)) {
    auto below = filesBelow(path);
    if (!below) return below.error();
    files = *std::move(below);
    std::erase_if(files, isNoSource);
  }
  Fingerprint sum;
  for (const fs::path& file : files) {
    const auto text = readFile(file.string());
    if (!text) return text.error();
    sum.add(file.lexically_relative(path).generic_string());
    for (const Line& line : linesOf(*text)) {
      sum.add(line.text);
      sum.add("\n");
    }
  }
  return digitsOf(sum);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// The section in which a line of a text in the config format stands; empty before the first one.
std::string sectionOf(std::string_view text, int line) {
  std::string name;
  for (const ConfigSection& section : detail::configSections(text))
    if (section.line < line) name = section.name;
  return name;
}

}  // namespace

Findings checkCalibratedFiles(const std::string& root) {
  Findings findings;
  const std::string list = pathOf(root, listName);
  if (!fs::exists(list)) return findings;
  CalibratedFiles calibrated;
  if (auto done = readConfig(list, calibrated); !done) {
    findings.add(done.error());
    return findings;
  }
  const bool installed = !fs::exists(pathOf(root, "src"));
  for (const CalibratedFile& file : calibrated.files) {
    std::vector<std::string> changed;
    for (const auto& [path, before] : file.sources) {
      if (installed && !fs::exists(pathOf(root, path))) continue;
      const auto now = fingerprintOf(root, path);
      if (!now)
        findings.add({.file = list, .field = file.file, .what = now.error().text()});
      else if (*now != before)
        changed.push_back(path);
    }
    if (changed.empty()) continue;
    findings.warn({.file = pathOf(root, file.file),
                   .what = listed(changed) + (changed.size() > 1 ? " have" : " has") +
                           " changed since it was measured to fit; made anew by: " + file.command});
  }
  return findings;
}

Result<void> keepCalibratedFile(const std::string& root, const std::string& file) {
  const std::string list = pathOf(root, listName);
  const auto text = readFile(list);
  if (!text) return text.error();
  CalibratedFiles calibrated;
  if (auto done = parseConfig(*text, list, calibrated); !done) return done.error();
  const auto found = std::ranges::find(calibrated.files, file, &CalibratedFile::file);
  if (found == calibrated.files.end())
    return Error{.file = list, .field = file, .what = "is not listed"};
  const std::string section = "files." + std::to_string(found - calibrated.files.begin());
  std::string kept = *text;
  const auto lines = linesOf(*text);
  for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
    const auto words = wordsOf(line->text);
    if (!words || words->size() != 3 || !words->front().text.starts_with("sources.")) continue;
    if (sectionOf(*text, line->number) != section) continue;
    const auto fingerprint = fingerprintOf(root, (*words)[1].text);
    if (!fingerprint) return fingerprint.error();
    const std::size_t old = words->back().text.size();
    kept.replace(line->text.data() + line->text.size() - old - text->data(), old, *fingerprint);
  }
  return writeFile(list, kept);
}

}  // namespace gt
