#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/Result.h"
#include "simulation/scene/MuJoCo.h"
#include "simulation/scene/Xml.h"

namespace gt {

/// An MJCF file as one document: with all files that it includes, and with absolute paths of the
/// meshes, height fields and textures that it names, so that it is valid in any working directory.
class ModelFile {
 public:
  /// Reads a file and the files that it includes. Adds errors to `errors`; empty if there are any.
  static std::optional<ModelFile> read(const std::string& path, std::vector<Error>& errors);

  const std::string& path() const { return path_; }
  /// Its element <mujoco>. The document may be changed before it is compiled.
  xmlNode* root() const { return xmlDocGetRootElement(document_.get()); }
  /// All elements of a name below <mujoco>, since sections may be repeated.
  std::vector<xmlNode*> sections(const char* name) const;
  /// An attribute of the element <compiler>. The last one counts; empty if there is none.
  std::string compilerAttribute(const char* name) const;
  /// The element <compiler> with an attribute; null if there is none.
  const xmlNode* compilerWith(const char* name) const;

  /// A message about an element or one of its attributes, with the file that it stands in.
  Error at(const xmlNode* node, const std::string& field, const std::string& what,
           Severity severity = Severity::error) const;

  /// Compiles this file alone. Errors name the file and the line of the element.
  Result<Model> compile() const;

 private:
  struct Included {
    std::string file;
    int depth;
  };

  ModelFile(std::string path, XmlDocument document)
      : path_{std::move(path)}, document_{std::move(document)} {}
  /// The file from which an element was read.
  Included originOf(const xmlNode* node) const;
  void include(std::vector<Error>& errors);
  xmlNode* replace(xmlNode* include, std::vector<std::string>& read, std::vector<Error>& errors);
  void resolvePaths(std::vector<Error>& errors);
  void resolvePaths(xmlNode* asset, const std::filesystem::path& folder, bool strip,
                    std::vector<Error>& errors);

  std::string path_;
  XmlDocument document_;
  std::map<const xmlNode*, Included> included_;  ///< The topmost elements of included files.
};

}  // namespace gt
