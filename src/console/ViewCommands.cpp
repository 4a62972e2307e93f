#include "console/Commands.h"

namespace gt {

std::vector<Command> viewCommands() {
  return {};
}

}  // namespace gt
