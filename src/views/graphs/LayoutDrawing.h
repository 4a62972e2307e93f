#pragma once
#include <string>

#include "framework/Layout.h"

namespace gt {

/// Describes a plan as text: the modules of each process in their order, and the representations
/// that are sent between processes (report 2.2.3).
std::string describePlan(const Plan& plan);

/// A plan as a drawing like the report's figure 2.2, in Graphviz's language: a box for each process
/// with its modules in their order, arrows for sent representations, thick ones for those that
/// start a cycle.
std::string drawPlan(const Plan& plan);

}  // namespace gt
