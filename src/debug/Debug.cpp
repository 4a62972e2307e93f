#include "debug/Debug.h"

namespace gt {

const std::vector<double>* Debug::received(const DebugKey& key) const {
  for (auto data = received_.rbegin(); data != received_.rend(); ++data)
    if (data->id == key.name()) return &data->data;
  return nullptr;
}

}  // namespace gt
