#include "xabsl/formats/xml/XmlSources.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "xabsl/formats/xml/XmlReader.h"

namespace xabsl::xml {

namespace {

// Limit for a whole behavior, after all inclusions are expanded.
constexpr std::size_t mostElementsInAll = 5'000'000;
constexpr int deepest = 400;

/// The inclusion of a file by another one.
struct Link {
  Element* place;
  int depth;
};

/// The size of a file; included files are added later.
struct Outline {
  std::vector<Link> links;
  std::size_t elements = 0;
  int height = 0;
  bool open = false;  ///< while that is being added
  bool complete = false;
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

std::optional<std::string> toXml(std::string& text) {
  if (!isXml(text)) return "this is no XML file";
  if (!toUtf8(text)) return "its encoding is not known or broken";
  return std::nullopt;
}

class IncludeLoader {
 public:
  IncludeLoader(const std::string& path, SourceFiles sources, syntax::Program& program,
                Reporter& reporter)
      : root_(path), sources_(std::move(sources)), program_(program), reporter_(reporter) {}

  Files run() {
    sources_.open(root_.generic_string(), toXml, nullptr);
    // In a loop: a chain of inclusions may be long or closed.
    for (std::size_t next = 0; next < program_.files.size() && !reporter_.full(); ++next) {
      readSource(static_cast<int>(next));
      outlines_.emplace_back();
      outline(files_[next].roots, 1, outlines_.back());
      for (const Link& link : outlines_.back().links) {
        const bool named = link.place->doctype.empty() || declare(files_[next].path, *link.place);
        if (named) follow(files_[next].path, *link.place);
      }
    }
    if (!reporter_.failed()) complete(0, 1);
    return std::move(files_);
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
    if (const auto problem = sources_.read(path, text)) {
      sources_.refuse({entity.doctype, entity.location}, *problem);
      return nullptr;
    }
    known->second = readEntities(text);
    return &known->second;
  }

  /// The path of what a file names, if that is below the folder of the first one.
  std::optional<std::string> resolve(const std::string& path, std::string_view target,
                                     Location location) {
    if (target.find(':') != std::string_view::npos) {
      sources_.refuse({target, location}, "only files are read, nothing is fetched");
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
    sources_.refuse({target, location},
                    "it lies outside of the folder of " + root_.filename().generic_string());
    return std::nullopt;
  }

  void follow(const std::string& path, Element& link) {
    const syntax::Include include{link.text, link.location};
    if (const auto full = resolve(path, link.text, link.location))
      link.file = sources_.open(*full, toXml, &include);
  }

  void readSource(int index) {
    const syntax::File& source = program_.files[at(index)];
    File& file = files_.emplace_back();
    file.path = source.path;
    readElements(index, source.text, reporter_, program_, file);
    if (!file.roots.empty() && file.dialect != files_.front().dialect)
      reporter_.error({index, 1, 1}, "this file is of another version of XABSL than '" +
                                         files_.front().path + "'");
  }

  /// Adds up a file with all that it includes. Refuses circles and what gets too large; false then.
  bool complete(std::size_t file, int depth) {
    Outline& whole = outlines_[file];
    if (whole.complete) return true;
    whole.open = true;
    for (const Link& link : whole.links) {
      const std::size_t included = at(link.place->file);
      Outline& part = outlines_[included];
      if (part.open) {
        reporter_.error(link.place->location, inQuotes(files_[included].path) + " includes itself");
        return false;
      }
      if (depth > deepest)
        part.height = deepest;
      else if (!complete(included, depth + 1))
        return false;
      whole.elements = std::min(whole.elements + part.elements, mostElementsInAll + 1);
      whole.height = std::max(whole.height, link.depth + part.height);
    }
    whole.open = false;
    whole.complete = whole.height <= deepest && whole.elements <= mostElementsInAll;
    if (!whole.complete)
      reporter_.fileError(files_[file].path, whole.height > deepest
                                                 ? "nested too deeply, with all that is included"
                                                 : "too large, with all that is included");
    return whole.complete;
  }

  std::filesystem::path root_;
  SourceFiles sources_;
  syntax::Program& program_;
  Reporter& reporter_;
  Files files_;
  std::vector<Outline> outlines_;
  std::map<std::string, Entities> doctypes_;
};

}  // namespace

Files readFiles(const std::string& path, SourceFiles sources, syntax::Program& program,
                Reporter& reporter) {
  return IncludeLoader(path, std::move(sources), program, reporter).run();
}

}  // namespace xabsl::xml
