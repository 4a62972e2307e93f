// What the build needs of xabsl before all else: the symbols of behaviors.
#include "Commands.h"

int main(int argc, char** argv) {
  return xabsl::app::run(argc, argv, {xabsl::app::addHeader});
}
