#include "match/report/Report.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "base/Base64.h"
#include "base/File.h"
#include "images/Jpeg.h"
#include "match/report/PageFiles.h"
#include "streams/Json.h"
#include "views/painting/Sheet.h"

namespace gt {
namespace {

/// Greatest number of samples of each robot that are drawn, also for longer matches.
constexpr std::size_t maxSamples = 1800;

std::string textOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// An object as text that people can read and compare line by line: one field a line, and one
/// element of a list a line.
std::string linesOf(const Json& object) {
  std::string text = "{";
  for (const auto& [name, value] : object.items()) {
    text += text.size() == 1 ? "\n " : ",\n ";
    text += textOf(name) + ": ";
    if (value.is_array() && !value.empty()) {
      for (std::size_t i = 0; i < value.size(); ++i)
        text += (i == 0 ? "[\n  " : ",\n  ") + textOf(value[i]);
      text += "\n ]";
    } else {
      text += textOf(value);
    }
  }
  return text + "\n}\n";
}

/// Minutes and seconds: 3:12.
std::string clockOf(Time time) {
  const std::string seconds = std::to_string(time.ms / 1000 % 60);
  return std::to_string(time.ms / 60'000) + (seconds.size() == 1 ? ":0" : ":") + seconds;
}

/// JSON as it may stand between script tags: no character of it means anything to HTML, and all of
/// it is ASCII.
std::string scriptSafe(const Json& json) {
  std::string safe;
  for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace)) {
    if (c == '<')
      safe += "\\u003c";
    else if (c == '>')
      safe += "\\u003e";
    else if (c == '&')
      safe += "\\u0026";
    else
      safe += c;
  }
  return safe;
}

std::string htmlSafe(std::string_view text) {
  std::string safe;
  for (const char c : text)
    if (c == '&' || c == '<' || c == '>' || c == '"')
      safe += "&#" + std::to_string(static_cast<int>(c)) + ";";
    else
      safe += c;
  return safe;
}

/// Rounds to a whole number, which is precise enough to draw, and short; null if it is not finite.
Json rounded(double value, double factor = 1) {
  const double scaled = value * factor;
  return std::abs(scaled) < 1e15 ? Json(std::llround(scaled)) : Json();
}

/// The samples as columns: positions and errors in mm, rotations in 0.01 rad. Where samples are
/// left out, the largest of their errors stays.
Json columnsOf(const std::vector<RobotSample>& samples, std::size_t stride) {
  Json x = Json::array(), y = Json::array(), rotation = Json::array(), error = Json::array();
  for (std::size_t i = 0; i < samples.size(); i += stride) {
    const Pose2D& pose = samples[i].pose;
    x.push_back(rounded(pose.translation.x()));
    y.push_back(rounded(pose.translation.y()));
    rotation.push_back(rounded(pose.rotation, 100));
    double largest = samples[i].localizationError;
    for (std::size_t k = i + 1; k < std::min(i + stride, samples.size()); ++k)
      largest = std::max(largest, samples[k].localizationError);
    error.push_back(rounded(largest));
  }
  return Json{{"x", x}, {"y", y}, {"rotation", rotation}, {"error", error}};
}

Json columnsOf(const std::vector<Vector2d>& points, std::size_t stride) {
  Json x = Json::array(), y = Json::array();
  for (std::size_t i = 0; i < points.size(); i += stride) {
    x.push_back(rounded(points[i].x()));
    y.push_back(rounded(points[i].y()));
  }
  return Json{{"x", x}, {"y", y}};
}

/// As JPEG: the cameras' noise makes a PNG five times as large.
std::string dataUri(const ReportPicture& picture) {
  std::vector<std::uint8_t> ycc;
  ycc.reserve(picture.rgb.size());
  for (std::size_t i = 0; i + 2 < picture.rgb.size(); i += 3) {
    const double r = picture.rgb[i], g = picture.rgb[i + 1], b = picture.rgb[i + 2];
    const double y = 0.299 * r + 0.587 * g + 0.114 * b;
    for (const double value : {y, 128 + (b - y) * 0.564, 128 + (r - y) * 0.713})
      ycc.push_back(static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0)));
  }
  const auto jpeg = encodeJpeg(ycc.data(), picture.width, picture.height, 3, 82);
  return "data:image/jpeg;base64," + base64(std::as_bytes(std::span{jpeg}));
}

bool isComplete(const ReportPicture& picture) {
  return picture.width > 0 && picture.height > 0 && picture.width <= 65500 &&
         picture.height <= 65500 &&
         picture.rgb.size() ==
             3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
}

Json picturesOf(const std::vector<ReportPicture>& pictures) {
  Json list = Json::array();
  for (const ReportPicture& picture : pictures)
    if (isComplete(picture))
      list.push_back(Json{{"title", picture.title},
                          {"width", picture.width},
                          {"height", picture.height},
                          {"source", dataUri(picture)}});
  return list;
}

/// All data of the page, in the format that its scripts read.
Json pageData(const MatchSummary& summary, const MatchTimes& times,
              const std::vector<ReportPicture>& pictures, const FieldDimensions& field) {
  std::size_t longest = summary.ball.size();
  for (const RobotSummary& robot : summary.robots)
    longest = std::max(longest, robot.samples.size());
  const std::size_t stride = std::max<std::size_t>(1, (longest + maxSamples - 1) / maxSamples);

  MatchSummary head = summary;
  head.ball.clear();
  for (RobotSummary& robot : head.robots) robot.samples.clear();
  Json match = toJson(head);
  for (std::size_t i = 0; i < summary.robots.size(); ++i)
    match["robots"][i]["samples"] = columnsOf(summary.robots[i].samples, stride);
  match["seed"] = std::to_string(summary.seed);  // JavaScript's numbers have 53 bits
  match["ball"] = columnsOf(summary.ball, stride);
  return Json{{"match", match},
              {"times", toJson(times)},
              {"field", toJson(field)},
              {"sampleSeconds", stride},
              {"pictures", picturesOf(pictures)}};
}

/// A template with each @NAME@ replaced; the inserted texts are not searched again.
std::string filled(std::string_view page,
                   const std::vector<std::pair<std::string_view, std::string>>& values) {
  std::string text;
  while (!page.empty()) {
    std::size_t at = page.size(), length = 0;
    const std::string* content = nullptr;
    for (const auto& [name, value] : values)
      if (const std::size_t found = page.find(name); found < at) {
        at = found;
        length = name.size();
        content = &value;
      }
    text += page.substr(0, at);
    if (content != nullptr) text += *content;
    page.remove_prefix(at + length);
  }
  return text;
}

}  // namespace

Result<void> writeMatchJson(const std::string& path, const MatchSummary& summary) {
  return writeFile(path, linesOf(toJson(summary)));
}

Result<void> writeTimesJson(const std::string& path, const MatchTimes& times) {
  return writeFile(path, linesOf(toJson(times)));
}

ReportPicture reportPicture(std::string title, const Image& image,
                            std::span<const Drawing> drawings, int scale) {
  Sheet sheet = imageSheet(image, scale);
  for (const Drawing& drawing : drawings)
    if (drawing.space == DrawingSpace::image)
      sheet.paint(drawing, {Vector2d::Zero(), static_cast<double>(scale)});
  return {std::move(title), sheet.width(), sheet.height(), sheet.pixels().pixels};
}

Result<void> writeReport(const std::string& path, const MatchSummary& summary,
                         const MatchTimes& times, const std::vector<ReportPicture>& pictures,
                         const FieldDimensions& field) {
  std::string score = "Red " + std::to_string(summary.redScore) + " : " +
                      std::to_string(summary.blueScore) + " Blue";
  if (summary.interrupted) score += ", interrupted at " + clockOf(summary.duration);
  return writeFile(
      path, filled(page::html(), {{"@TITLE@", htmlSafe(score)},
                                  {"@STYLE@", std::string{page::style()}},
                                  {"@DATA@", scriptSafe(pageData(summary, times, pictures, field))},
                                  {"@CHART_LIBRARY@", std::string{page::chartLibrary()}},
                                  {"@SCRIPT@", std::string{page::script()}},
                                  {"@PLAY_SCRIPT@", std::string{page::playScript()}},
                                  {"@FIELD_SCRIPT@", std::string{page::fieldScript()}},
                                  {"@CHART_SCRIPT@", std::string{page::chartScript()}}}));
}

}  // namespace gt
