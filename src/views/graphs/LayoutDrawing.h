#pragma once
#include <string>

#include "framework/Layout.h"

namespace gt {

/// A plan for people, as text: what runs where in which order, and what crosses from where to where
/// (report 2.2.3).
std::string describePlan(const Plan& plan);

/// A plan as a drawing like the report's figure 2.2, in Graphviz's language: a box for each process
/// with its modules in their order, arrows for what crosses, thick ones for what starts a cycle.
std::string drawPlan(const Plan& plan);

}  // namespace gt
