#pragma once

#include <string_view>

/// The XML Schemas of XABSL 2.1 and 3.1, embedded from the files in this folder.
namespace xabsl::schema {

std::string_view agentCollection();
std::string_view option();
std::string_view symbols();
std::string_view basicBehaviors();
std::string_view optionDefinitions();
std::string_view parameter();
std::string_view expressions();
std::string_view xabsl31();

}  // namespace xabsl::schema
