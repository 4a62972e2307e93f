#include "xabsl/formats/Sources.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <system_error>
#include <utility>

#include "xabsl/formats/XmlParser.h"
#include "xabsl/formats/XmlReader.h"
#include "xabsl/formats/XmlSchema.h"
#include "xabsl/formats/XmlSources.h"
#include "xabsl/language/Parser.h"
#include "xabsl/language/Utf8.h"

namespace xabsl {

namespace {

std::string normal(const std::filesystem::path& path) {
  return path.lexically_normal().generic_string();
}

/// True if there is no character that only other kinds of files hold. Otherwise each of them would
/// be an error of its own.
bool isText(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' &&
           std::string_view("\t\n\v\f\r").find(c) == std::string_view::npos;
  });
}

/// The path of what a file includes.
std::string target(const std::string& path, const syntax::Include& include) {
  std::string name(include.path);
  std::replace(name.begin(), name.end(), '\\', '/');  // as written on Windows
  return normal(std::filesystem::path(path).parent_path() / name);
}

/// Follows the includes in a loop: a chain of them may be long or closed.
class SourceLoader {
 public:
  SourceLoader(const FileReader& read, syntax::Program& program, Reporter& reporter)
      : read_(read), program_(program), reporter_(reporter) {}

  void run(const std::string& path) {
    load(path, nullptr);
    while (!pending_.empty() && !reporter_.full()) {
      const Pending next = std::move(pending_.front());
      pending_.pop_front();
      load(next.path, &next.location);
    }
    resolveIncludes();
  }

 private:
  struct Pending {
    std::string path;
    Location location;  // of the include
  };

  void load(const std::string& path, const Location* include) {
    if (!indices_.emplace(path, -1).second) return;
    std::string text;
    std::optional<std::string> problem =
        indices_.size() > mostFiles ? "more than 10000 files" : read_(path, text);
    sum_ += text.size();
    if (!problem && sum_ > largestSum) problem = "the files are larger than 8 MiB together";
    if (!problem && !isText(text)) problem = "this is no text file";
    if (problem) {
      if (include)
        reporter_.error(*include, "cannot include '" + path + "': " + *problem);
      else
        reporter_.fileError(path, *problem);
      return;
    }
    const std::string_view kept = program_.keep(toUtf8(std::move(text)));
    const int file = reporter_.addFile(path, kept);
    indices_[path] = file;
    program_.files.push_back({path, kept, {}, {}});
    Parser(file, kept, reporter_, program_).parse();
    for (const syntax::Include& included : program_.files.back().includes)
      pending_.push_back({target(path, included), included.location});
  }

  void resolveIncludes() {
    for (syntax::File& file : program_.files)
      for (syntax::Include& include : file.includes) {
        const auto found = indices_.find(target(file.path, include));
        if (found != indices_.end()) include.file = found->second;
      }
  }

  const FileReader& read_;
  syntax::Program& program_;
  Reporter& reporter_;
  std::map<std::string, int> indices_;  // into the files of the program; -1: cannot be read
  std::deque<Pending> pending_;
  std::size_t sum_ = 0;
};

}  // namespace

std::optional<std::string> readFile(const std::string& path, std::string& text,
                                    std::size_t largest) {
  std::error_code error;
  // A pipe or a device may never end.
  if (!std::filesystem::is_regular_file(path, error)) return "cannot open the file";
  if (std::filesystem::file_size(path, error) > largest || error)
    return "the file is larger than " + std::to_string(largest >> 20) + " MiB";
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return "cannot open the file";
  text.assign(std::istreambuf_iterator<char>(stream), {});
  return std::nullopt;
}

FileReader diskReader() {
  return [](const std::string& path, std::string& text) { return readFile(path, text); };
}

FileReader readerOf(const VirtualFiles& files) {
  return [&files](const std::string& path, std::string& text) -> std::optional<std::string> {
    const auto found = files.find(path);
    if (found == files.end()) return "there is no such file";
    if (found->second.size() > largestFile) return "the file is larger than 2 MiB";
    text = found->second;
    return std::nullopt;
  };
}

void readSources(const std::string& path, const FileReader& read, syntax::Program& program,
                 Reporter& reporter) {
  std::string first;
  if (read(normal(path), first) || !xml::isXml(first))
    return SourceLoader(read, program, reporter).run(normal(path));
  const xml::Files files = xml::readFiles(path, read, program, reporter);
  if (!reporter.failed()) xml::validate(files, reporter);
  if (!reporter.failed()) xml::Parser(files, reporter, program).parse();
}

}  // namespace xabsl
