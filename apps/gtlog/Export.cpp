#include "gtlog/Export.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/File.h"

namespace gt {
namespace {

using Left = std::vector<Error>;

/// A list longer than this makes a table that nobody can read.
constexpr std::size_t mostColumns = 10'000;
constexpr const char* tooManyColumns = "would have more than 10000 columns";

/// Adds what was left out, each once, though the log is read several times.
void addOnce(const Left& more, Left& left) {
  for (const Error& error : more)
    if (std::ranges::none_of(left, [&](const Error& e) { return e.text() == error.text(); }))
      left.push_back(error);
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

/// The columns of a topic, in the order of the fields. Of the elements of a list the order is that
/// of their numbers.
class Columns {
 public:
  /// False if there are too many.
  bool add(const Json& message) {
    std::size_t at = 0;
    ++messages_;
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
  std::uint64_t messages() const { return messages_; }
  /// Where a path is; nowhere, if another program has changed the log since.
  std::optional<std::size_t> place(const std::string& path) const {
    const auto found = places_.find(path);
    return found == places_.end() ? std::nullopt : std::optional{found->second};
  }

 private:
  std::uint64_t messages_ = 0;
  std::vector<std::string> paths_;
  std::map<std::string, std::size_t> places_;
};

/// The columns of the selected messages.
Result<Columns> columnsOf(const std::string& log, const Selection& selection, Left& left) {
  Columns columns;
  auto done = selection.forEachJson(
      log,
      [&](const McapChannel& channel, std::uint64_t, const Json& json) -> Result<void> {
        if (columns.add(json)) return {};
        return Error{.file = log, .field = channel.topic, .what = tooManyColumns};
      },
      left);
  if (!done) return done.error();
  return columns;
}

}  // namespace

Result<std::vector<Error>> exportJson(const std::string& log, const Selection& selection,
                                      std::FILE* to, const std::string& name, std::uint64_t limit) {
  std::uint64_t count = 0;
  const Error enough;
  Left left;
  const auto done = selection.forEachJson(
      log,
      [&](const McapChannel& channel, std::uint64_t time, const Json& message) -> Result<void> {
        const Json line{{"topic", channel.topic}, {"time", time}, {"message", message}};
        // Texts of others may not be UTF-8.
        const auto text = line.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
        if (std::fwrite(text.data(), 1, text.size(), to) != text.size())
          return Error{.file = name,
                       .what = std::string("cannot be written: ") + std::strerror(errno)};
        if (++count == limit) return enough;
        return {};
      },
      left);
  if (!done && (limit == 0 || count < limit)) return done.error();
  return left;
}

Result<std::vector<Error>> exportCsv(const std::string& log, const Selection& selection,
                                     const std::string& topic, const std::string& to) {
  Selection one = selection;
  one.topics = {topic};
  Left left;
  const auto columns = columnsOf(log, one, left);
  if (!columns) return columns.error();
  if (columns->messages() == 0 && !left.empty()) return left;
  auto file = OutputFile::open(to);
  if (!file) return file.error();
  std::string head = "time";
  for (const std::string& path : columns->paths()) head += ',' + path;
  if (!file->put(head + '\n')) return file->error();
  std::vector<std::string> row(columns->paths().size());
  Left again;
  auto done = one.forEachJson(
      log,
      [&](const McapChannel&, std::uint64_t time, const Json& json) -> Result<void> {
        std::fill(row.begin(), row.end(), "");
        forEachScalar(json, "", [&](const std::string& path, const Json& scalar) {
          if (const auto place = columns->place(path)) row[*place] = cell(scalar);
        });
        auto line = fmt::format("{}.{:09}", time / 1'000'000'000, time % 1'000'000'000);
        for (const std::string& text : row) line += ',' + text;
        if (!file->put(line + '\n')) return file->error();
        return {};
      },
      again);
  if (done) done = file->close();
  if (!done) return done.error();
  addOnce(again, left);
  return left;
}

Result<std::vector<Error>> exportTrace(const std::string& log, const Selection& selection,
                                       const std::string& to) {
  Selection one = selection;
  one.topics = {"/BehaviorTrace"};
  std::string trace;
  Left left;
  auto done = one.forEachJson(
      log,
      [&](const McapChannel&, std::uint64_t, const Json& json) -> Result<void> {
        const auto text = json.find("text");
        if (text == json.end() || !text->is_string())
          return Error{.file = log, .field = one.topics.front(), .what = "is no behavior trace"};
        trace += text->get_ref<const std::string&>();
        return {};
      },
      left);
  if (done && trace.empty())
    return Error{.file = log, .field = one.topics.front(), .what = "is not there"};
  if (done) done = writeFile(to, trace);
  if (!done) return done.error();
  return left;
}

namespace {

/// A CSV file for each topic; those that make no table are reported.
Result<Left> exportTables(const std::string& log, const Selection& selection,
                          const std::vector<std::string>& topics, const std::string& to) {
  std::error_code failed;
  std::filesystem::create_directories(to, failed);
  if (failed) return Error{.file = to, .what = failed.message()};
  Left left;
  std::set<std::string> names;
  for (const std::string& topic : topics) {
    std::string name = topic.substr(std::min(topic.find_first_not_of('/'), topic.size()));
    std::replace(name.begin(), name.end(), '/', '.');
    if (!names.insert(name).second) {
      left.push_back({.file = log, .field = topic, .what = name + ".csv is that of another topic"});
      continue;
    }
    const auto done =
        exportCsv(log, selection, topic, (std::filesystem::path{to} / (name + ".csv")).string());
    if (!done && done.error().what != tooManyColumns) return done.error();
    addOnce(done ? *done : Left{done.error()}, left);
  }
  return left;
}

/// Messages as lines of JSON in a file.
Result<Left> exportJsonFile(const std::string& log, const Selection& selection,
                            const std::string& to) {
  auto file = OutputFile::open(to);
  if (!file) return file.error();
  auto left = exportJson(log, selection, file->file(), to);
  if (!left) return left;
  if (auto done = file->close(); !done) return done.error();
  return left;
}

}  // namespace

Result<std::vector<Error>> exportLog(const std::string& log, const Selection& selection,
                                     const std::string& to) {
  const std::string extension = std::filesystem::path{to}.extension().string();
  if (extension == ".json" || extension == ".jsonl") return exportJsonFile(log, selection, to);
  if (extension == ".trace") return exportTrace(log, selection, to);
  const auto reader = McapReader::open(log);
  if (!reader) return reader.error();
  std::vector<std::string> topics;
  for (const McapChannel& channel : reader->channels())
    if (selection.holds(channel) &&
        std::find(topics.begin(), topics.end(), channel.topic) == topics.end())
      topics.push_back(channel.topic);
  if (extension != ".csv") return exportTables(log, selection, topics, to);
  if (topics.size() == 1) return exportCsv(log, selection, topics.front(), to);
  return Error{.file = to,
               .what = "a CSV file is of one topic; choose it by --topic, or name a folder"};
}

}  // namespace gt
