#include "Logs.h"

#include <nanobind/ndarray.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <tuple>
#include <type_traits>

#include "Failure.h"
#include "Types.h"
#include "Values.h"
#include "base/Suggestion.h"
#include "images/Jpeg.h"
#include "logs/LogSelection.h"
#include "streams/RecordedMessage.h"
#include "streams/RecordedTable.h"
#include "streams/mcap/Mcap.h"

namespace gt::python {
namespace {

namespace nb = nanobind;
using namespace nb::literals;

using Topics = std::vector<std::string>;

/// An array that has taken a vector over.
template <typename N, typename T>
nb::object ownedArray(std::vector<T> numbers) {
  auto* const data = new std::vector<T>{std::move(numbers)};
  const nb::capsule owner{data, [](void* p) noexcept { delete static_cast<std::vector<T>*>(p); }};
  const std::size_t shape[] = {data->size() * sizeof(T) / sizeof(N)};
  return nb::ndarray<nb::numpy, N>(data->data(), 1, shape, owner).cast();
}

nb::dict describe(const RecordedTable::Element& element);

nb::dict describe(const RecordedTable::Field& field) {
  nb::dict about = describe(field.element);
  about["name"] = field.name;
  about["count"] = field.count;
  about["list"] = field.pool;
  about["index_names"] = field.indexNames;
  return about;
}

nb::dict describe(const RecordedTable::Element& element) {
  nb::dict about;
  const bool text = element.kind == Kind::text, record = element.kind == Kind::record;
  about["letters"] = text ? nb::object{nb::int_(element.pool)} : nb::object{nb::none()};
  about["dtype"] = element.kind == Kind::boolean ? "bool" : numberName(element.number);
  about["names"] = element.names;
  nb::list fields;
  for (const RecordedTable::Field& field : element.fields) fields.append(describe(field));
  about["fields"] = record ? nb::object{fields} : nb::object{nb::none()};
  return about;
}

/// Reads an MCAP log from its begin with each call.
class LogFile {
 public:
  /// If it is strict, a log that is damaged anywhere is an error.
  LogFile(std::string path, bool strict)
      : path_{std::move(path)}, strict_{strict}, reader_{orThrow(McapReader::open(path_))} {
    if (strict_ && !reader_.damage().empty()) throw Failure{reader_.damage().front()};
    findUnreadable();
  }

  /// A line for each thing that is damaged; reads all of the log once to find it.
  nb::object damage() {
    if (!looked_) {
      const nb::gil_scoped_release released;
      reader_.seek(0);
      while (reader_.next()) {
      }
      looked_ = true;
    }
    std::string text;
    const auto addLine = [&](const Error& error) {
      text += (text.empty() ? "" : "\n") + error.text();
    };
    std::ranges::for_each(reader_.damage(), addLine);
    std::ranges::for_each(lost_.errors(path_), addLine);
    // Names in a broken log may be no UTF-8.
    if (text.empty()) return nb::none();
    return nb::steal<nb::str>(
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
  }

  /// For each channel its topic, the name of its schema, and why its messages cannot be read; empty
  /// if they can.
  nb::list channels() const {
    nb::list all;
    for (const McapChannel& channel : reader_.channels())
      all.append(named([&] {
        return nb::make_tuple(channel.topic, channel.schemaName, whyUnreadable(channel));
      }));
    return all;
  }

  /// Names and entries.
  nb::list metadata() const {
    nb::list all;
    for (const McapReader::Metadata& metadata : reader_.metadata())
      named([&] { all.append(nb::make_tuple(metadata.name, metadata.entries)); });
    return all;
  }

  /// Names and bytes.
  nb::list attachments() const {
    nb::list all;
    for (const McapReader::Attachment& attachment : reader_.attachments())
      named([&] {
        all.append(nb::make_tuple(attachment.name,
                                  nb::bytes(attachment.data.data(), attachment.data.size())));
      });
    return all;
  }

  /// For each of some topics how a row is made up, the rows, the pools, and the times (ns).
  nb::dict read(const Topics& topics) {
    std::map<std::string, Table> tables;
    {
      const nb::gil_scoped_release released;
      readTables(topics, tables);
    }
    nb::dict all;
    for (auto& entry : tables) {  // a structured binding is not captured by clang 14
      Table& table = entry.second;
      const nb::dict row = named([&] { return describe(table.rows->row()); });
      auto [rows, pools] = std::move(*table.rows).release();
      nb::list asArrays;
      for (RecordedTable::Pool& pool : pools)
        asArrays.append(ownedArray<std::uint8_t>(std::move(pool)));
      const nb::str name = named([&] { return nb::str{entry.first.c_str()}; });
      all[name] = nb::make_tuple(row, ownedArray<std::uint8_t>(std::move(rows)), asArrays,
                                 ownedArray<std::uint64_t>(std::move(table.times)));
    }
    return all;
  }

  /// The messages of some topics in the log's order: time (ns), topic, object.
  nb::list messages(const Topics& topics) {
    std::map<std::uint16_t, Recorded> recorded;
    for (const McapChannel* channel : channelsOf(topics))
      recorded.emplace(channel->id, Recorded{channel, definitionOf(*channel), typeOf(*channel)});
    nb::list all;
    forEachMessage([&](const McapMessage& message) {
      const auto found = recorded.find(message.channel);
      if (found == recorded.end()) return;
      const auto& [channel, definition, type] = found->second;
      const auto value = type->make();
      if (const auto done = readRecorded(definition, message.data, {type->type(), value.get()});
          !done)
        return lose(*channel, message, done.error());
      all.append(
          nb::make_tuple(message.time, channel->topic, toPython({*type->type(), value.get()})));
    });
    return all;
  }

 private:
  /// What makes Python's texts of the log's: those of a broken log may be none.
  template <typename Make>
  std::invoke_result_t<Make> named(Make&& make) const {
    try {
      return make();
    } catch (nb::python_error& error) {
      if (!error.matches(PyExc_UnicodeDecodeError)) throw;
      throw Failure{Error{.file = path_, .what = "a name in it is not UTF-8"}};
    }
  }

  struct Table {
    const McapChannel* first = nullptr;
    std::unique_ptr<RecordedTable> rows;
    std::vector<std::uint64_t> times;
  };
  struct Recorded {
    const McapChannel* channel;
    MessageDefinition definition;
    const RepresentationType* type;
  };

  [[noreturn]] void fail(const McapChannel& channel, const Error& error) const {
    const std::string field = error.field.empty() ? "" : "." + error.field;
    throw Failure{Error{.file = path_, .field = channel.topic + field, .what = error.what}};
  }

  /// A message that cannot be read loses itself, if the log need not be whole.
  void lose(const McapChannel& channel, const McapMessage& message, const Error& error) {
    if (strict_) fail(channel, error);
    if (counted_.insert({channel.id, message.time, message.sequence}).second)
      lost_.add(channel, message.time, error.text());
  }

  void findUnreadable() {
    Definitions definitions{path_};
    std::map<std::string, const McapChannel*> first;
    for (const McapChannel& channel : reader_.channels()) {
      const auto definition = definitions.of(channel);
      if (const auto made = definition ? RecordedTable::make(**definition)
                                       : Result<RecordedTable>{definition.error()};
          !made) {
        unreadable_[channel.id] = made.error().what;
        continue;
      }
      const auto [known, isNew] = first.emplace(channel.topic, &channel);
      if (!isNew && known->second->schemaText != channel.schemaText)
        unreadable_[channel.id] = "has another schema than the topic's first channel";
    }
  }
  std::string whyUnreadable(const McapChannel& channel) const {
    const auto found = unreadable_.find(channel.id);
    return found == unreadable_.end() ? "" : found->second;
  }

  /// The channels of topics that can be read; an error if none of a topic can.
  std::vector<const McapChannel*> channelsOf(const Topics& topics) const {
    std::vector<const McapChannel*> found;
    Topics known;
    for (const McapChannel& channel : reader_.channels()) known.push_back(channel.topic);
    for (const std::string& topic : topics) {
      const std::size_t before = found.size();
      std::string why = "the log has no such topic" + suggestion(topic, known);
      for (const McapChannel& channel : reader_.channels()) {
        if (channel.topic != topic) continue;
        if (unreadable_.contains(channel.id))
          why = whyUnreadable(channel);
        else
          found.push_back(&channel);
      }
      if (found.size() == before) throw Failure{Error{.file = path_, .field = topic, .what = why}};
    }
    return found;
  }

  MessageDefinition definitionOf(const McapChannel& channel) const {
    return orThrow(MessageDefinition::parse(channel.schemaName, channel.schemaText));
  }

  const RepresentationType* typeOf(const McapChannel& channel) const {
    const std::string& schema = channel.schemaName;
    const std::string name = schema.substr(schema.rfind('/') + 1);
    const auto found = knownRepresentations().find(name);
    if (found == knownRepresentations().end())
      fail(channel, Error{.what = "gt2003.representations has no class " + name});
    return found->second;
  }

  template <typename Take>
  void forEachMessage(Take&& take) {
    reader_.seek(0);
    while (const auto message = reader_.next()) {
      if (strict_ && !reader_.damage().empty()) break;
      take(*message);
    }
    if (strict_ && !reader_.damage().empty()) throw Failure{reader_.damage().front()};
  }

  void readTables(const Topics& topics, std::map<std::string, Table>& tables) {
    std::map<std::uint16_t, Table*> byChannel;
    for (const McapChannel* channel : channelsOf(topics)) {
      Table& table = tables[channel->topic];
      if (!table.rows) {
        auto rows = RecordedTable::make(definitionOf(*channel));
        if (!rows) fail(*channel, rows.error());
        table.first = channel;
        table.rows = std::make_unique<RecordedTable>(std::move(*rows));
      }
      byChannel[channel->id] = &table;
    }
    forEachMessage([&](const McapMessage& message) {
      const auto found = byChannel.find(message.channel);
      if (found == byChannel.end()) return;
      Table& table = *found->second;
      if (const auto done = table.rows->add(message.data); !done)
        return lose(*table.first, message, done.error());
      table.times.push_back(message.time);
    });
  }

  std::string path_;
  bool strict_;
  McapReader reader_;
  bool looked_ = false;
  std::map<std::uint16_t, std::string> unreadable_;  ///< Channels, and why.
  LostMessages lost_;
  std::set<std::tuple<std::uint16_t, std::uint64_t, std::uint32_t>> counted_;  ///< Those in it.
};

nb::object decodedJpeg(
    const nb::ndarray<const std::uint8_t, nb::ndim<1>, nb::c_contig, nb::device::cpu>& bytes) {
  RawImage image = orThrow(decodeJpeg({bytes.data(), bytes.size()}));
  const nb::object flat = ownedArray<std::uint8_t>(std::move(image.data));
  return flat.attr("reshape")(image.height, image.width, image.components);
}

}  // namespace

void bindLogs(nb::module_& module) {
  module.def("_decode_jpeg", &decodedJpeg);
  nb::class_<LogFile>(module, "LogFile", "The file of a `gt2003.Log`.")
      .def(nb::init<std::string, bool>(), "path"_a, "strict"_a)
      .def_prop_ro("damage", &LogFile::damage)
      .def("channels", &LogFile::channels)
      .def("metadata", &LogFile::metadata)
      .def("attachments", &LogFile::attachments)
      .def("read", &LogFile::read, "topics"_a)
      .def("messages", &LogFile::messages, "topics"_a);
}

}  // namespace gt::python
