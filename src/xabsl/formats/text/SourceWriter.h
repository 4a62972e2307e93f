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
/// agents that includes them. In names, `-` is replaced by `_`, because text does not allow it;
/// names that become equal are an error. The files are named relative to the folder of `root`, the
/// file with the agents. The result is valid only if the reporter has not failed.
VirtualFiles writeText(const syntax::Program& program, const std::string& root, Reporter& reporter);

/// Writes a valid behavior as XML of XABSL 2.1 or 3.1, from its syntax tree and its model. The
/// files of 2.1 are laid out as in report F.1; constructs that 2.1 cannot express are reported as
/// errors. Those of 3.1 are laid out as by the public compilers: with folders Options, Symbols and
/// BasicBehaviors, and a file that names all entities.
VirtualFiles writeXml(const syntax::Program& program, const Model& model, Dialect dialect,
                      const std::string& root, Reporter& reporter);

/// The comments of a program that are not kept as documentation, in their order.
class LooseComments {
 public:
  explicit LooseComments(const syntax::Program& program);

  /// Takes the comments of a file before a place that were not taken yet, without their marks.
  std::vector<std::string> before(Location place);

  /// Takes the remaining comments of all files.
  std::vector<std::string> rest();

 private:
  std::vector<std::vector<const syntax::Comment*>> files_;
  std::vector<std::size_t> taken_;
};

/// The output folder of the declarations in a file of the program: the folder of that file relative
/// to that of the first one.
std::string folderOf(const syntax::Program& program, Location location);

/// The declarations in all namespaces of one name and kind, which become one file.
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
