#include "xabsl/Behavior.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <system_error>

#include "xabsl/Analyzer.h"
#include "xabsl/Parser.h"
#include "xabsl/Reporter.h"
#include "xabsl/Syntax.h"

namespace xabsl {

namespace {

// Far beyond any behavior; they bound memory and time whatever is in the files.
constexpr std::size_t largestFile = 2u << 20;
constexpr std::size_t largestSum = 8u << 20;
constexpr std::size_t mostFiles = 10'000;

/// Puts the text of a file into its last argument; otherwise returns why it cannot.
using Reader =
    std::function<std::optional<std::string>(const std::string& path, std::string& text)>;

std::string normal(const std::filesystem::path& path) {
  return path.lexically_normal().generic_string();
}

std::optional<std::string> readFile(const std::string& path, std::string& text) {
  std::error_code error;
  // A pipe or a device may never end.
  if (!std::filesystem::is_regular_file(path, error)) return "cannot open the file";
  if (std::filesystem::file_size(path, error) > largestFile || error)
    return "the file is larger than 2 MiB";
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return "cannot open the file";
  text.assign(std::istreambuf_iterator<char>(stream), {});
  return std::nullopt;
}

/// True if there is no character that only other kinds of files hold. Otherwise each of them would
/// be an error of its own.
bool isText(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) {
    return static_cast<unsigned char>(c) < ' ' &&
           std::string_view("\t\n\v\f\r").find(c) == std::string_view::npos;
  });
}

/// Reads a file and all that it includes, each once, in a loop: a chain of includes may be long or
/// closed.
class Loader {
 public:
  explicit Loader(const Reader& read) : read_(read) {}

  Compilation compile(const std::string& path) {
    load(path, nullptr);
    while (!pending_.empty() && !reporter_.full()) {
      const Pending next = pending_.front();
      pending_.pop_front();
      load(next.path, &next.location);
    }
    Compilation compilation;
    if (!reporter_.failed()) {
      auto model = std::make_shared<Model>(Analyzer(program_, reporter_).analyze());
      if (!reporter_.failed()) compilation.behavior.emplace(std::move(model));
    }
    compilation.diagnostics = reporter_.take();
    return compilation;
  }

 private:
  struct Pending {
    std::string path;
    Location location;  // of the include
  };

  void load(const std::string& path, const Location* include) {
    if (!known_.insert(path).second) return;
    std::string text;
    std::optional<std::string> problem =
        known_.size() > mostFiles ? "more than 10000 files" : read_(path, text);
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
    const int file = reporter_.addFile(path);
    texts_.push_back(std::move(text));
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    for (const Include& included : Parser(file, texts_.back(), reporter_, program_).parse()) {
      std::string name(included.path);
      std::replace(name.begin(), name.end(), '\\', '/');  // as written on Windows
      pending_.push_back({normal(folder / name), included.location});
    }
  }

  const Reader& read_;
  Reporter reporter_;
  std::deque<std::string> texts_;  // the syntax tree looks into these
  syntax::Program program_;
  std::set<std::string> known_;
  std::deque<Pending> pending_;
  std::size_t sum_ = 0;
};

}  // namespace

Compilation compile(const std::string& path) {
  const Reader read = readFile;
  return Loader(read).compile(normal(path));
}

Compilation compile(const std::string& path, const VirtualFiles& files) {
  const Reader read = [&](const std::string& name,
                          std::string& text) -> std::optional<std::string> {
    const auto found = files.find(name);
    if (found == files.end()) return "there is no such file";
    if (found->second.size() > largestFile) return "the file is larger than 2 MiB";
    text = found->second;
    return std::nullopt;
  };
  return Loader(read).compile(normal(path));
}

}  // namespace xabsl
