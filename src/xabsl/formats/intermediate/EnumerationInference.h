#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Model.h"
#include "xabsl/language/Reporter.h"

namespace xabsl {

class Symbols;

/// Infers the enumerations from their use, as required for intermediate code: values that are
/// compared or assigned belong to the same domain. A domain gets its name from a declaration, or
/// from its elements, which are written `name.element`.
class EnumerationInference {
 public:
  EnumerationInference(const Symbols* registered, Reporter& reporter)
      : registered_(registered), reporter_(reporter) {}

  /// The domain of a name; a new one, if the name is new.
  int named(std::string_view name);

  /// A new domain without a name.
  int fresh();

  /// Declares an enumeration with all its elements.
  int declare(std::string_view name, const std::vector<std::string_view>& elements,
              Location location);

  /// Unites two domains. Returns false if they have different names.
  bool unite(int a, int b);

  /// Records an element at a place where a domain is expected. Returns the number of the mention.
  int mention(int domain, std::string_view text, Location location);

  /// Ends the inference and returns the enumerations of the model. Reports unknown ones.
  std::vector<Enumeration> resolve();

  /// After `resolve`: the enumeration of a domain.
  int enumeration(int domain);

  /// After `resolve`: the index of the mentioned element in its enumeration.
  int element(int mention) const { return mentions_[at(mention)].element; }

 private:
  struct Domain {
    int parent;
    std::string name;  ///< empty: not known
    int enumeration = -1;
  };

  struct Mention {
    int domain;
    std::string_view text;
    Location location;
    int element = -1;
  };

  int root(int domain);
  std::string inferredName(const std::vector<int>& mentions) const;
  bool isKnown(std::string_view name) const;
  void addElement(Mention& mention, std::vector<Enumeration>& enumerations);
  int enumerationNamed(const std::string& name, std::vector<Enumeration>& enumerations);

  const Symbols* registered_;
  Reporter& reporter_;
  std::vector<Domain> domains_;
  std::vector<Mention> mentions_;
  std::map<std::string, int, std::less<>> names_;
  std::map<std::string, Enumeration, std::less<>> declared_;
  std::map<std::string, int, std::less<>> resolved_;
  std::vector<std::map<std::string, int, std::less<>>> elements_;  ///< per enumeration resolved
};

}  // namespace xabsl
