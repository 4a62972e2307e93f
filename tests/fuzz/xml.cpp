#include <string>

#include "AllForms.h"
#include "Fuzz.h"

/// The bytes are the files of a behavior, one behind the other; a line `=== path` begins one.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = gt::textOf(data, size);
  xabsl::VirtualFiles files;
  std::string path = "agents.xml";
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (line.substr(0, 4) == "=== ")
      path = line.substr(4);
    else
      files[path].append(line).append("\n");
    begin = end + 1;
  }
  gt::goThroughAllForms("agents.xml", files);
  return 0;
}
