#include "base/Contract.h"

#include <cstdio>
#include <cstdlib>

namespace gt {

void require(bool condition, std::string_view sentence) {
  if (!condition) violate(sentence);
}

void violate(std::string_view sentence) {
  std::fprintf(stderr, "%.*s\n", static_cast<int>(sentence.size()), sentence.data());
  std::abort();
}

}  // namespace gt
