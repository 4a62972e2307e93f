#include "motionnet/Listing.h"

#include <cctype>

namespace motionnet {

std::string xabslName(std::string_view motion) {
  std::string name;
  for (const char c : motion) {
    const auto u = static_cast<unsigned char>(c);
    if (std::isupper(u) && !name.empty()) name += '_';
    name += c == '-' ? '_' : static_cast<char>(std::tolower(u));
  }
  return name;
}

std::string listing(const std::vector<std::string>& motions) {
  std::string elements = "none";
  for (const auto& motion : motions) elements += ",\n    " + xabslName(motion);
  return "/** The special actions: made by `motionnet list` from the files in motions/. A robot "
         "makes it anew when it starts. */\n"
         "namespace special_actions(\"Special Actions\") {\n"
         "  enum special_action input {\n    " +
         elements + "\n  };\n}\n";
}

}  // namespace motionnet
