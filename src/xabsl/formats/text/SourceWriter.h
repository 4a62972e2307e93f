#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "xabsl/language/Reporter.h"
#include "xabsl/language/Syntax.h"
#include "xabsl/language/VirtualFiles.h"

namespace xabsl {

struct Model;

/// Writes a behavior as XABSL 3.1 text: a file for each namespace and each option, and one with the
/// agents that includes them. Names that text does not allow get `_` for `-`; two that become the
/// same are an error. The files are named relative to the folder of `root`, the file with the
/// agents. Of use only if the reporter has not failed.
VirtualFiles writeText(const syntax::Program& program, const std::string& root, Reporter& reporter);

/// Writes a valid behavior as XML of XABSL 2.1 or 3.1, from its syntax tree and the model of that.
/// The files of 2.1 are laid out as in report F.1; what 2.1 cannot express is an error at its
/// place. Those of 3.1 are laid out as by the public compilers: with folders Options, Symbols and
/// BasicBehaviors, and a file that names all entities.
VirtualFiles writeXml(const syntax::Program& program, const Model& model, Dialect dialect,
                      const std::string& root, Reporter& reporter);

/// The comments of a program that are not kept as documentation, in their order.
class LooseComments {
 public:
  explicit LooseComments(const syntax::Program& program);

  /// Those of a file before a place that were not taken yet, without their marks.
  std::vector<std::string> before(Location place);

  /// Those of all files that were not taken yet.
  std::vector<std::string> rest();

 private:
  std::vector<std::vector<const syntax::Comment*>> files_;
  std::vector<std::size_t> taken_;
};

/// Where what is declared in a file of the program is written: the folder of that file relative to
/// the first one.
std::string folderOf(const syntax::Program& program, Location location);

/// What stands in the namespaces of one name and kind, which become one file.
struct Collection {
  using Member = std::variant<const syntax::Enumeration*, const syntax::Symbol*,
                              const syntax::Constant*, const syntax::Behavior*>;

  const syntax::Namespace* space = nullptr;
  bool behaviors = false;
  std::vector<Member> members;  ///< in the order of their places
};

const syntax::Declaration& declarationOf(const Collection::Member& member);

/// The declarations of a program, collected by their namespaces, in the order of the program.
std::vector<Collection> collectionsOf(const syntax::Program& program);

}  // namespace xabsl
