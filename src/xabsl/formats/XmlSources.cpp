#include "xabsl/formats/XmlSources.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <utility>

#include "xabsl/formats/XmlReader.h"

namespace xabsl::xml {

namespace {

// Of a behavior as a whole, with everything in its place.
constexpr std::size_t mostElementsInAll = 5'000'000;
constexpr int deepest = 400;

/// Where a file includes another one.
struct Link {
  Element* place;
  int depth;
};

/// What a file consists of, without what it includes.
struct Outline {
  std::vector<Link> links;
  std::size_t elements = 0;
  int height = 0;
};

void outline(std::vector<Element>& elements, int depth, Outline& result) {
  result.height = std::max(result.height, depth);
  for (Element& element : elements) {
    ++result.elements;
    if (element.kind == Element::Kind::entity || element.kind == Element::Kind::include)
      result.links.push_back({&element, depth});
    outline(element.children, depth + 1, result);
  }
}

class IncludeLoader {
 public:
  IncludeLoader(const std::string& path, const FileReader& read, syntax::Program& program,
                Reporter& reporter)
      : root_(std::filesystem::path(path).lexically_normal()),
        read_(read),
        program_(program),
        reporter_(reporter) {}

  Files run() {
    enter(root_.generic_string(), nullptr);
    // In a loop: a chain of inclusions may be long or closed. Elements stay where they are when the
    // list of files grows.
    for (std::size_t next = 0; next < files_.size() && !reporter_.full(); ++next) {
      outlines_.emplace_back();
      outline(files_[next].roots, 1, outlines_.back());
      for (const Link& link : outlines_.back().links) {
        const bool named = link.place->doctype.empty() || declare(files_[next].path, *link.place);
        if (named) follow(files_[next].path, *link.place);
      }
    }
    if (!reporter_.failed()) checkWhole();
    return {std::make_move_iterator(files_.begin()), std::make_move_iterator(files_.end())};
  }

 private:
  using Entities = std::map<std::string, std::string, std::less<>>;

  /// Finds in a document type definition which file an entity is. Paths in there are meant from its
  /// own folder.
  bool declare(const std::string& path, Element& entity) {
    const std::optional<std::string> full = resolve(path, entity.doctype, entity.location);
    const Entities* entities = full ? entitiesOf(*full, entity) : nullptr;
    if (!entities) return false;
    const auto found = entities->find(entity.name);
    if (found == entities->end()) {
      reporter_.error(entity.location,
                      "entity '" + std::string(entity.name) + "' is not declared in " + *full);
      return false;
    }
    const std::filesystem::path folder =
        std::filesystem::path(std::string(entity.doctype)).parent_path();
    entity.text = program_.keep((folder / found->second).generic_string());
    return true;
  }

  const Entities* entitiesOf(const std::string& path, const Element& entity) {
    const auto [known, added] = doctypes_.emplace(path, Entities());
    if (!added) return &known->second;
    std::string text;
    std::optional<std::string> problem = read_(path, text);
    sum_ += text.size();
    if (!problem && sum_ > largestSum) problem = "the files are larger than 8 MiB together";
    if (problem) {
      refuse(entity.location, entity.doctype, *problem);
      return nullptr;
    }
    known->second = readEntities(text);
    return &known->second;
  }

  void refuse(Location location, std::string_view target, const std::string& why) {
    reporter_.error(location, "cannot include '" + std::string(target) + "': " + why);
  }

  /// The path of what a file names, if that is below the folder of the first one.
  std::optional<std::string> resolve(const std::string& path, std::string_view target,
                                     Location location) {
    if (target.find(':') != std::string_view::npos) {
      refuse(location, target, "only files are read, nothing is fetched");
      return std::nullopt;
    }
    std::string name(target);
    std::replace(name.begin(), name.end(), '\\', '/');  // as written on Windows
    const std::filesystem::path full =
        (std::filesystem::path(path).parent_path() / name).lexically_normal();
    const std::filesystem::path folder = root_.parent_path();
    const std::filesystem::path inside =
        full.lexically_relative(folder.empty() ? std::filesystem::path(".") : folder);
    if (!inside.empty() && *inside.begin() != "..") return full.generic_string();
    refuse(location, target,
           "it lies outside of the folder of " + root_.filename().generic_string());
    return std::nullopt;
  }

  void follow(const std::string& path, Element& link) {
    const std::optional<std::string> full = resolve(path, link.text, link.location);
    if (!full) return;
    link.file = enter(*full, &link);
    syntax::File& including = program_.files[at(link.location.file)];
    including.includes.push_back({link.text, link.location, link.file});
  }

  int enter(const std::string& path, const Element* link) {
    const auto known = indices_.find(path);
    if (known != indices_.end()) return known->second;
    std::string text;
    std::optional<std::string> problem =
        indices_.size() >= mostFiles ? "more than 10000 files" : read_(path, text);
    sum_ += text.size();
    if (!problem && sum_ > largestSum) problem = "the files are larger than 8 MiB together";
    if (!problem && !isXml(text)) problem = "this is no XML file";
    if (!problem && !toUtf8(text)) problem = "its encoding is not known or broken";
    if (problem) {
      indices_[path] = -1;
      if (link)
        reporter_.error(link->location,
                        "cannot include '" + std::string(link->text) + "': " + *problem);
      else
        reporter_.fileError(path, *problem);
      return -1;
    }
    const std::string_view kept = program_.keep(std::move(text));
    const int file = reporter_.addFile(path, kept);
    indices_[path] = file;
    program_.files.push_back({path, kept, {}, {}});
    files_.push_back({path, {}});
    readElements(file, kept, reporter_, program_, files_.back());
    if (!files_.back().roots.empty() && files_.back().dialect != files_.front().dialect)
      reporter_.error({file, 1, 1}, "this file is of another version of XABSL than '" +
                                        files_.front().path + "'");
    return file;
  }

  /// Adds up from files that include nothing to those that include them; what is left over then is
  /// in a circle, or leads into one.
  void checkWhole() {
    std::vector<std::size_t> waiting(files_.size());
    std::vector<std::vector<std::size_t>> includers(files_.size());
    std::vector<std::size_t> ready;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      waiting[i] = outlines_[i].links.size();
      for (const Link& link : outlines_[i].links) includers[at(link.place->file)].push_back(i);
      if (waiting[i] == 0) ready.push_back(i);
    }
    for (std::size_t next = 0; next < ready.size(); ++next) {
      const std::size_t done = ready[next];
      Outline& whole = outlines_[done];
      for (const Link& link : whole.links) {
        const Outline& part = outlines_[at(link.place->file)];
        whole.elements = std::min(whole.elements + part.elements, mostElementsInAll + 1);
        whole.height = std::max(whole.height, std::min(link.depth + part.height, deepest + 1));
      }
      if (whole.elements > mostElementsInAll || whole.height > deepest)
        return reporter_.fileError(files_[done].path,
                                   whole.height > deepest
                                       ? "nested too deeply, with all that is included"
                                       : "too large, with all that is included");
      for (const std::size_t includer : includers[done])
        if (--waiting[includer] == 0) ready.push_back(includer);
    }
    if (ready.size() < files_.size()) reportCircle(waiting);
  }

  void reportCircle(const std::vector<std::size_t>& waiting) {
    std::size_t file = 0;
    while (waiting[file] == 0) ++file;
    std::vector<bool> seen(files_.size(), false);
    for (;;) {
      seen[file] = true;
      const auto next =
          std::find_if(outlines_[file].links.begin(), outlines_[file].links.end(),
                       [&](const Link& link) { return waiting[at(link.place->file)] > 0; });
      file = at(next->place->file);
      if (seen[file])
        return reporter_.error(next->place->location,
                               inQuotes(files_[file].path) + " includes itself");
    }
  }

  std::filesystem::path root_;
  const FileReader& read_;
  syntax::Program& program_;
  Reporter& reporter_;
  std::deque<File> files_;
  std::deque<Outline> outlines_;
  std::map<std::string, int> indices_;  // -1: cannot be read
  std::map<std::string, Entities> doctypes_;
  std::size_t sum_ = 0;
};

}  // namespace

Files readFiles(const std::string& path, const FileReader& read, syntax::Program& program,
                Reporter& reporter) {
  return IncludeLoader(path, read, program, reporter).run();
}

}  // namespace xabsl::xml
