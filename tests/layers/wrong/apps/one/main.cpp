// A program may include itself and src, but no other program.
#include "One.h"
#include "base/Upward.h"
#include "two/Two.h"
