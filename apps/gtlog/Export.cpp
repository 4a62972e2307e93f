#include "gtlog/Export.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "streams/File.h"
#include "streams/RecordedMessage.h"

namespace gt {
namespace {

struct FileCloser {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, FileCloser>;

/// A list longer than this makes a table that nobody can read.
constexpr std::size_t mostColumns = 10'000;
constexpr const char* tooManyColumns = "would have more than 10000 columns";

Result<File> openFile(const std::string& path) {
  File file{std::fopen(path.c_str(), "w")};
  if (!file)
    return Error{.file = path, .what = std::string("cannot be written: ") + std::strerror(errno)};
  return file;
}

/// An export that is whole or failed.
Result<std::vector<Error>> wholly(const Result<void>& done) {
  if (!done) return done.error();
  return std::vector<Error>{};
}

/// Writes a text; `name` is the file's in errors.
Result<void> put(std::FILE* to, const std::string& text, const std::string& name) {
  if (std::fwrite(text.data(), 1, text.size(), to) == text.size()) return {};
  return Error{.file = name, .what = std::string("cannot be written: ") + std::strerror(errno)};
}

Result<void> closeFile(File file, const std::string& path) {
  const bool good = std::ferror(file.get()) == 0;
  if (std::fclose(file.release()) == 0 && good) return {};
  return Error{.file = path, .what = std::string("cannot be written: ") + std::strerror(errno)};
}

/// Calls visit(path, scalar) for every scalar of a message; elements are numbered: feet.2.z.
template <typename Visit>
void forEachScalar(const Json& json, const std::string& path, const Visit& visit) {
  const std::string prefix = path.empty() ? "" : path + ".";
  if (json.is_object())
    for (const auto& [name, part] : json.items()) forEachScalar(part, prefix + name, visit);
  else if (json.is_array())
    for (std::size_t i = 0; i < json.size(); ++i)
      forEachScalar(json[i], prefix + std::to_string(i), visit);
  else
    visit(path, json);
}

/// A cell of CSV (RFC 4180): texts in quotes where they need it.
std::string cell(const Json& scalar) {
  if (scalar.is_null()) return "";
  if (!scalar.is_string()) return scalar.dump();
  const auto& text = scalar.get_ref<const std::string&>();
  if (text.find_first_of(",\"\r\n") == text.npos) return text;
  std::string quoted = "\"";
  for (const char c : text) (quoted += c) += c == '"' ? "\"" : "";
  return quoted + "\"";
}

/// Visits the selected messages as JSON.
template <typename Visit>
Result<void> forEachJson(const std::string& log, const Selection& selection, const Visit& visit) {
  Definitions definitions{log};
  return selection.forEach(
      log, [&](const McapChannel& channel, const McapMessage& message) -> Result<void> {
        const auto definition = definitions.of(channel);
        if (!definition) return definition.error();
        const auto json = recordedJson(**definition, message.data);
        if (!json) return Error{.file = log, .field = channel.topic, .what = json.error().text()};
        return visit(channel, message.time, *json);
      });
}

/// The columns of a topic, in the order of the fields. Of the elements of a list the order is that
/// of their numbers.
class Columns {
 public:
  /// False if there are too many.
  bool add(const Json& message) {
    std::size_t at = 0;
    forEachScalar(message, "", [&](const std::string& path, const Json&) {
      const auto known = places_.find(path);
      if (known != places_.end()) {
        at = known->second + 1;
        return;
      }
      if (paths_.size() >= mostColumns) return;
      paths_.insert(paths_.begin() + static_cast<std::ptrdiff_t>(at), path);
      for (std::size_t i = at; i < paths_.size(); ++i) places_[paths_[i]] = i;
      ++at;
    });
    return paths_.size() < mostColumns;
  }
  const std::vector<std::string>& paths() const { return paths_; }
  std::size_t place(const std::string& path) const { return places_.at(path); }

 private:
  std::vector<std::string> paths_;
  std::map<std::string, std::size_t> places_;
};

}  // namespace

Result<void> exportJson(const std::string& log, const Selection& selection, std::FILE* to,
                        const std::string& name, std::uint64_t limit) {
  std::uint64_t count = 0;
  const Error enough;
  const auto done = forEachJson(
      log, selection,
      [&](const McapChannel& channel, std::int64_t time, const Json& message) -> Result<void> {
        const Json line{{"topic", channel.topic}, {"time", time}, {"message", message}};
        // Texts of others may not be UTF-8.
        const auto text = line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
        if (auto written = put(to, text, name); !written) return written;
        if (++count == limit) return enough;
        return {};
      });
  if (!done) return limit == 0 || count < limit ? done : Result<void>{};
  const auto reader = McapReader::open(log);
  if (!reader) return reader.error();
  return reader->damage() ? Result<void>{*reader->damage()} : Result<void>{};
}

Result<void> exportCsv(const std::string& log, const Selection& selection, const std::string& topic,
                       const std::string& to) {
  Selection one = selection;
  one.topics = {topic};
  Columns columns;
  auto done =
      forEachJson(log, one, [&](const auto&, std::int64_t, const Json& json) -> Result<void> {
        if (columns.add(json)) return {};
        return Error{.file = log, .field = topic, .what = tooManyColumns};
      });
  if (!done) return done;
  auto file = openFile(to);
  if (!file) return file.error();
  std::string head = "time";
  for (const std::string& path : columns.paths()) head += ',' + path;
  if (done = put(file->get(), head + '\n', to); !done) return done;
  std::vector<std::string> row(columns.paths().size());
  done =
      forEachJson(log, one, [&](const auto&, std::int64_t time, const Json& json) -> Result<void> {
        std::fill(row.begin(), row.end(), "");
        forEachScalar(json, "", [&](const std::string& path, const Json& scalar) {
          row[columns.place(path)] = cell(scalar);
        });
        auto line = fmt::format("{}.{:09}", time / 1'000'000'000, time % 1'000'000'000);
        for (const std::string& text : row) line += ',' + text;
        return put(file->get(), line + '\n', to);
      });
  if (!done) return done;
  return closeFile(std::move(*file), to);
}

Result<void> exportTrace(const std::string& log, const Selection& selection,
                         const std::string& to) {
  Selection one = selection;
  one.topics = {"/BehaviorTrace"};
  std::string trace;
  const auto done =
      forEachJson(log, one, [&](const auto&, std::int64_t, const Json& json) -> Result<void> {
        const auto text = json.find("text");
        if (text == json.end() || !text->is_string())
          return Error{.file = log, .field = one.topics.front(), .what = "is no behavior trace"};
        trace += text->template get_ref<const std::string&>();
        return {};
      });
  if (!done) return done;
  if (trace.empty()) return Error{.file = log, .field = one.topics.front(), .what = "is not there"};
  return writeFile(to, trace);
}

namespace {

/// A CSV file for each topic; those that make no table are reported.
Result<std::vector<Error>> exportTables(const std::string& log, const Selection& selection,
                                        const std::vector<std::string>& topics,
                                        const std::string& to) {
  std::error_code failed;
  std::filesystem::create_directories(to, failed);
  if (failed) return Error{.file = to, .what = failed.message()};
  std::vector<Error> left;
  for (const std::string& topic : topics) {
    std::string name = topic.substr(std::min(topic.find_first_not_of('/'), topic.size()));
    std::replace(name.begin(), name.end(), '/', '.');
    const auto done =
        exportCsv(log, selection, topic, (std::filesystem::path{to} / (name + ".csv")).string());
    if (!done && done.error().what != tooManyColumns) return done.error();
    if (!done) left.push_back(done.error());
  }
  return left;
}

}  // namespace

Result<std::vector<Error>> exportLog(const std::string& log, const Selection& selection,
                                     const std::string& to) {
  const std::string extension = std::filesystem::path{to}.extension().string();
  if (extension == ".json" || extension == ".jsonl") {
    auto file = openFile(to);
    if (!file) return file.error();
    auto done = exportJson(log, selection, file->get(), to);
    if (done) done = closeFile(std::move(*file), to);
    return wholly(done);
  }
  if (extension == ".trace") return wholly(exportTrace(log, selection, to));
  const auto reader = McapReader::open(log);
  if (!reader) return reader.error();
  std::vector<std::string> topics;
  for (const McapChannel& channel : reader->channels())
    if (selection.holds(channel) &&
        std::find(topics.begin(), topics.end(), channel.topic) == topics.end())
      topics.push_back(channel.topic);
  if (extension != ".csv") return exportTables(log, selection, topics, to);
  if (topics.size() == 1) return wholly(exportCsv(log, selection, topics.front(), to));
  return Error{.file = to,
               .what = "a CSV file is of one topic; choose it by --topic, or name a folder"};
}

}  // namespace gt
