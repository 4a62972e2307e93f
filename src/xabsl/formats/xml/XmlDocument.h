#pragma once
#include <libxml/tree.h>

#include <memory>

namespace xabsl::xml {

struct DocumentDeleter {
  void operator()(xmlDoc* document) const { xmlFreeDoc(document); }
};
/// A document of libxml2.
using Document = std::unique_ptr<xmlDoc, DocumentDeleter>;

}  // namespace xabsl::xml
