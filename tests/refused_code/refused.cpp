// Mistakes that must not compile, and the sentences that the compiler must print: a line
// `// refused: SENTENCE` stands before each. The test `refused_code` compares.
#include "framework/SolutionTable.h"
#include "streams/Json.h"

using namespace gt;

struct Sense {
  int value = 0;
  static constexpr auto fields() { return Fields{field<&Sense::value>()}; }
};
struct Guess {
  int value = 0;
  static constexpr auto fields() { return Fields{field<&Guess::value>()}; }
};
struct Guesser {
  using Outputs = std::tuple<Guess>;
};

// refused: fields() of a struct leaves out one of its members
struct Forgetful {
  int a = 0, b = 0;
  static constexpr auto fields() { return Fields{field<&Forgetful::a>()}; }
};
const Type& forgetful = typeOf<Forgetful>();

// refused: fields() of a struct lists a member twice
struct Repeating {
  int a = 0, b = 0;
  static constexpr auto fields() {
    return Fields{field<&Repeating::a>(), field<&Repeating::a>().named("b")};
  }
};
const Type& repeating = typeOf<Repeating>();

// refused: fields() of a struct gives two of them the same name
struct Confusing {
  int a = 0, b = 0;
  static constexpr auto fields() {
    return Fields{field<&Confusing::a>(), field<&Confusing::b>().named("a")};
  }
};
const Type& confusing = typeOf<Confusing>();

// refused: a sentence that leans on another field's
struct Leaning {
  int a = 0, b = 0;
  static constexpr auto fields() {
    return Fields{field<&Leaning::a>("number of balls"), field<&Leaning::b>("likewise of robots")};
  }
};
const Type& leaning = typeOf<Leaning>();

// refused: a sentence without words
struct Empty {
  int a = 0;
  static constexpr auto fields() { return Fields{field<&Empty::a>("")}; }
};
const Type& empty = typeOf<Empty>();

// refused: is not a member of
struct Far {
  int a = 0;
  static constexpr auto fields() { return Fields{field<&Far::a>(Unit::mile)}; }
};
const Type& far = typeOf<Far>();

// refused: the enumerators of a streamed enumeration count from 0 without gaps
enum class Gap { a, b, c = 5 };
const Type& gap = typeOf<Gap>();
enum class FromOne { a = 1, b };
const Type& fromOne = typeOf<FromOne>();
enum class Negative { a = -1, b };
const Type& negative = typeOf<Negative>();
enum class High { a = 200 };
const Type& high = typeOf<High>();

// refused: update() of a module takes inputs as const T&
class ByValue {
 public:
  void update(Sense, Guess&) {}
};
// refused: a module has one member function update(), which is neither overloaded nor a template
class Overloaded {
 public:
  void update(const Sense&, Guess&) {}
  void update(Guess&) {}
};
// refused: update() of a module returns void, and is neither static nor noexcept
class Returning {
 public:
  bool update(const Sense&, Guess&) { return true; }
};
// refused: a solution must provide every output of its task: this one is missing
class Silent {
 public:
  void update(const Sense&) {}
};
// refused: a solution provides outputs of its task only: this one is none
class Meddling {
 public:
  void update(Sense&, Guess&) {}
};

void add(SolutionTable& table) {
  table.add<Guesser, ByValue>("A");
  table.add<Guesser, Overloaded>("B");
  table.add<Guesser, Returning>("C");
  table.add<Guesser, Silent>("D");
  table.add<Guesser, Meddling>("E");
}
