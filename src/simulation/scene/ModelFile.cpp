#include "simulation/scene/ModelFile.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

namespace gt {
namespace {

namespace fs = std::filesystem;

constexpr int deepestInclude = 16;
constexpr std::size_t mostIncludes = 1000;

bool isFile(const std::string& path) {
  std::error_code code;
  return fs::is_regular_file(path, code);
}

/// A path relative to a folder, as an absolute one; without ".." unless that leads out of a link.
std::string pathIn(const fs::path& folder, const fs::path& path) {
  std::error_code code;
  const fs::path whole = fs::absolute(folder / path, code), plain = whole.lexically_normal();
  if (fs::exists(whole, code) && !fs::equivalent(whole, plain, code)) return whole.string();
  return plain.string();
}

/// The element that begins at or before a line of a text that was written from a document.
const xmlNode* elementAt(const xmlDoc& document, const std::string& text, int line) {
  const XmlDocument again = parseXml(text);
  if (!again) return nullptr;
  int before = 0, count = 0;
  forEachElement(xmlDocGetRootElement(again.get()),
                 [&](const xmlNode* node) { before += lineOf(node) <= line; });
  const xmlNode* found = nullptr;
  forEachElement(xmlDocGetRootElement(const_cast<xmlDoc*>(&document)), [&](const xmlNode* node) {
    if (++count == before) found = node;
  });
  return found;
}

/// The number of the sensor that a message of MuJoCo is about: such messages have no line.
std::optional<std::size_t> sensorIn(const std::string& message) {
  if (message.find(" in sensor '") == message.npos) return std::nullopt;
  const auto id = message.find("(id = ");
  if (id == message.npos) return std::nullopt;
  return static_cast<std::size_t>(std::atoi(message.c_str() + id + 6));
}

}  // namespace

std::optional<ModelFile> ModelFile::read(const std::string& path, std::vector<Error>& errors) {
  auto document = readXml(path, "mujoco");
  if (!document) {
    errors.push_back(document.error());
    return std::nullopt;
  }
  const std::size_t before = errors.size();
  ModelFile file{path, std::move(*document)};
  file.include(errors);
  file.resolvePaths(errors);
  if (errors.size() > before) return std::nullopt;
  return file;
}

std::vector<xmlNode*> ModelFile::sections(const char* name) const {
  std::vector<xmlNode*> found;
  for (xmlNode* child : elementsOf(root()))
    if (nameOf(child) == name) found.push_back(child);
  return found;
}

const xmlNode* ModelFile::compilerWith(const char* name) const {
  const xmlNode* found = nullptr;
  for (const xmlNode* compiler : sections("compiler"))
    if (!attribute(compiler, name).empty()) found = compiler;
  return found;
}

std::string ModelFile::compilerAttribute(const char* name) const {
  const xmlNode* compiler = compilerWith(name);
  return compiler ? attribute(compiler, name) : "";
}

ModelFile::Included ModelFile::originOf(const xmlNode* node) const {
  for (; node; node = node->parent)
    if (const auto found = included_.find(node); found != included_.end()) return found->second;
  return {path_, 0};
}

Error ModelFile::at(const xmlNode* node, const std::string& field, const std::string& what,
                    Severity severity) const {
  return {.file = originOf(node).file,
          .line = lineOf(node),
          .field = field,
          .what = what,
          .severity = severity};
}

void ModelFile::include(std::vector<Error>& errors) {
  std::vector<std::string> read{pathIn("", path_)};
  const auto visit = [&](const auto& self, xmlNode* parent) -> void {
    for (xmlNode* child = parent->children; child;) {
      if (child->type == XML_ELEMENT_NODE && nameOf(child) == "include") {
        child = replace(child, read, errors);
      } else {
        if (child->type == XML_ELEMENT_NODE) self(self, child);
        child = child->next;
      }
    }
  };
  visit(visit, root());
}

/// Puts the elements of a file in the place of an <include>. Returns the node to continue with. As
/// in MuJoCo, paths are relative to the file that is read first, and no file is included twice.
xmlNode* ModelFile::replace(xmlNode* include, std::vector<std::string>& read,
                            std::vector<Error>& errors) {
  const int depth = originOf(include).depth + 1;
  const std::string name = attribute(include, "file");
  const std::string file = pathIn(fs::path{path_}.parent_path(), name);
  std::optional<Error> wrong;
  XmlDocument document;
  if (name.empty()) {
    wrong = at(include, "file", "expected the name of a file");
  } else if (include->children) {
    wrong = at(include, "include", "has no content");
  } else if (!isFile(file)) {
    wrong = at(include, "file", "there is no file " + file);
  } else if (std::find(read.begin(), read.end(), file) != read.end()) {
    wrong = at(include, "file", "a second time " + file);
  } else if (depth > deepestInclude || read.size() > mostIncludes) {
    wrong = at(include, "include",
               depth > deepestInclude ? "is deeper than " + std::to_string(deepestInclude)
                                      : "is one more than " + std::to_string(mostIncludes));
  } else if (auto found = readXml(file, ""); !found) {
    wrong = found.error();
  } else {
    document = std::move(*found);
  }
  xmlNode* next = include->next;
  if (wrong) {
    errors.push_back(*wrong);
  } else {
    read.push_back(file);
    xmlNode* first = nullptr;
    for (xmlNode* child : elementsOf(xmlDocGetRootElement(document.get()))) {
      xmlNode* copy = xmlDocCopyNode(child, document_.get(), 1);
      xmlAddPrevSibling(include, copy);
      included_[copy] = {file, depth};
      if (!first) first = copy;
    }
    if (first)
      next = first;
    else
      errors.push_back(at(include, "file", "there are no elements in " + file));
  }
  included_.erase(include);  // its address may be another element's soon
  xmlUnlinkNode(include);
  xmlFreeNode(include);
  return next;
}

void ModelFile::resolvePaths(std::vector<Error>& errors) {
  const bool strip = compilerAttribute("strippath") == "true";
  const fs::path folder = fs::path{path_}.parent_path();
  const fs::path meshes = folder / compilerAttribute("meshdir"),
                 textures = folder / compilerAttribute("texturedir");
  for (xmlNode* compiler : sections("compiler"))
    for (const char* name : {"strippath", "meshdir", "texturedir"})
      xmlUnsetProp(compiler, BAD_CAST name);
  std::set<std::string> names;
  for (xmlNode* section : sections("asset"))
    for (xmlNode* asset : elementsOf(section)) {
      // Assets without a name have that of their file. MuJoCo takes several of one file, but does
      // not take a name that is stated twice.
      const fs::path file{attribute(asset, "file")};
      if (attribute(asset, "name").empty() && !file.empty() &&
          !names.contains(nameOf(asset) + " " + file.stem().string()))
        setAttribute(asset, "name", file.stem().string());
      names.insert(nameOf(asset) + " " + attribute(asset, "name"));
      resolvePaths(asset, nameOf(asset) == "texture" ? textures : meshes, strip, errors);
    }
}

void ModelFile::resolvePaths(xmlNode* asset, const fs::path& folder, bool strip,
                             std::vector<Error>& errors) {
  for (const char* name :
       {"file", "fileright", "fileleft", "fileup", "filedown", "filefront", "fileback"}) {
    fs::path file{attribute(asset, name)};
    if (file.empty()) continue;
    if (strip) file = file.filename();
    const std::string path = pathIn(folder, file);
    if (!isFile(path)) errors.push_back(at(asset, name, "there is no file " + path));
    setAttribute(asset, name, path);
  }
}

Result<Model> ModelFile::compile() const {
  const std::string text = xmlText(*document_);
  auto model = compileModel(text, path_);
  if (model) return model;
  Error error = model.error();
  const xmlNode* node = error.line > 0 ? elementAt(*document_, text, error.line) : nullptr;
  if (const auto sensor = sensorIn(error.what)) {
    std::vector<xmlNode*> sensors;
    for (const xmlNode* section : sections("sensor"))
      for (xmlNode* element : elementsOf(section)) sensors.push_back(element);
    if (*sensor < sensors.size()) node = sensors[*sensor];
  }
  if (!node) return Error{.file = path_, .what = error.what};
  return at(node, error.field, error.what);
}

}  // namespace gt
