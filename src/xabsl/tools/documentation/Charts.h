#pragma once

#include <string>
#include <vector>

#include "xabsl/language/Model.h"
#include "xabsl/tools/documentation/Links.h"
#include "xabsl/tools/documentation/Usage.h"

namespace xabsl::documentation {

/// A chart for each agent, option, common decision tree and state, by their indices in the model;
/// first in Graphviz's language, then as SVG. An empty text means that there is no chart.
struct Charts {
  std::vector<std::string> agents;           ///< option graphs
  std::vector<std::string> options;          ///< states, transitions, and what they call
  std::vector<std::string> commonDecisions;  ///< decision trees, of the options
  std::vector<std::string> states;           ///< decision trees, of the states

  /// Calls a function with each list of charts.
  template <typename Visit>
  void forEachList(Visit visit) {
    for (std::vector<std::string>* list : {&agents, &options, &commonDecisions, &states})
      visit(*list);
  }
};

/// The charts in Graphviz's language. Charts with thousands of nodes, which nobody could read, are
/// left out.
Charts describeCharts(const Model& model, const Usage& usage, const Links& links);

}  // namespace xabsl::documentation
