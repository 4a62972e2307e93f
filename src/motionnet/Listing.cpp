#include "motionnet/Listing.h"

namespace motionnet {

std::string listing(const Net& net) {
  std::string xml =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<enumerated-output-symbol name=\"special-action-id\" description=\"the special actions\">\n";
  for (std::size_t i = 1; i < net.motions.size(); ++i)
    xml += "  <enum-element name=\"special-action-id." + net.motions[i] + "\"/>\n";
  return xml + "</enumerated-output-symbol>\n";
}

}  // namespace motionnet
