#pragma once

#include <string>
#include <string_view>

#include "xabsl/language/Model.h"
#include "xabsl/tools/documentation/Charts.h"
#include "xabsl/tools/documentation/Links.h"
#include "xabsl/tools/documentation/Usage.h"

namespace xabsl::documentation {

/// All inputs of the pages.
struct Content {
  const Model& model;
  const Usage& usage;
  const Links& links;
  const Charts& charts;  ///< as SVG
};

// The main part of each page.
std::string overviewPage(const Content& content);
std::string agentPage(const Content& content, int agent);
std::string optionPage(const Content& content, int option);
/// Symbols, constants, enumerations and basic behaviors of a namespace; with -1 those outside of
/// namespaces.
std::string namespacePage(const Content& content, int space);

/// The script with the names that the search field finds, with their pages.
std::string searchEntries(const Content& content);

/// True if a namespace has declarations; with -1: if there are declarations outside of namespaces.
bool holdsAnything(const Model& model, int space);

// Parts of several pages.
std::string anchor(const std::string& address, std::string_view text);
std::string code(std::string_view text);
std::string title(const std::string& kind, const std::string& name);
std::string declared(const Model& model, Location location);
std::string chart(const std::string& svg, const std::string& what);
std::string parameterTable(const Content& content, const std::vector<Parameter>& parameters,
                           const std::string& prefix = {});
std::string typeText(const Content& content, Type type);
/// Range and unit as in the language, `[0..1] "mm"` without the quotes.
std::string measure(const std::string& range, const std::string& unit);
/// The options that use something, with the states that use it.
std::string places(const Content& content, const Thing& thing);

}  // namespace xabsl::documentation
