#include "Commands.h"

int main(int argc, char** argv) {
  using namespace xabsl::app;
  return run(
      argc, argv,
      {addCheck, addCompile, addConvert, addDoc, addFormat, addHeader, addLsp, addTest, addTrace});
}
