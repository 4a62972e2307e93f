#pragma once

#include <random>
#include <string>

namespace xabsl::test {

/// Writes random behaviors with all constructs of the language. Every second option is called with
/// parameters by the option above it.
class RandomBehavior {
 public:
  explicit RandomBehavior(unsigned seed) : random_(seed) {}

  std::string write() {
    std::string text = R"(
namespace all("Symbols") {
  enum color { red, green, blue };
  enum step { first, second };
  float input x; float input y; bool input p; bool input q; enum color input c; enum color input d;
  float input f(float a; bool b; enum color e;);
  bool input g(float a;);
  enum color input h(enum color e; float a;);
  float output out_float; bool output out_bool; enum color output out_color;
  float internal in_float; bool internal in_bool; enum color internal in_color;
  enum step internal in_step;
  float const k = -2.5;
}
namespace skills("Skills") {
  behavior walk { float speed; bool careful; enum color e; }
  behavior stop {}
}
agent main("Main", o0);
)";
    for (option_ = 0; option_ < options; ++option_) text += option();
    return text;
  }

 private:
  static constexpr int options = 6;

  int number(int below) { return static_cast<int>(random_() % static_cast<unsigned>(below)); }
  bool chance(int percent) { return number(100) < percent; }
  template <typename... Choices>
  std::string pick(Choices... choices) {
    const std::string all[] = {choices...};
    return all[number(sizeof...(choices))];
  }

  std::string option() {
    states_ = 2 + number(3);
    std::string text = "option o" + std::to_string(option_) + " {\n";
    if (option_ > 0) text += "float @v; bool @w; enum color @u;\n";
    const bool common = chance(50);
    if (common) {
      text += "common decision { if (" + boolean(3) + ") " + transition(1);
      if (chance(50)) text += " else if (" + boolean(2) + ") " + transition(0);
      text += " }\n";
    }
    if (chance(50)) text += "common action { " + actions() + "}\n";
    for (int s = 0; s < states_; ++s) {
      text += (s == 0 ? "initial " : "") + std::string(chance(40) ? "target " : "") + "state s" +
              std::to_string(s);
      cooperative_ = s > 0 && chance(20);
      if (cooperative_)
        text += pick(" capacity 1", " capacity 2", " synchronized 1", " synchronized 2");
      text += " { decision { " + std::string(common ? "else " : "") + transition(3) +
              " } action { " + actions() + "} }\n";
      cooperative_ = false;
    }
    return text + "}\n";
  }

  std::string transition(int depth) {
    if (depth > 0 && chance(70))
      return "{ if (" + boolean(3) + ") " + transition(depth - 1) + " else " +
             transition(depth - 1) + " }";
    return chance(30) ? "stay;" : "goto s" + std::to_string(number(states_)) + ";";
  }

  std::string actions() {
    std::string text;
    for (int i = number(4); i >= 0; --i) text += action();
    return text;
  }

  std::string action() {
    switch (number(option_ + 1 < options ? 10 : 8)) {
      case 0:
        return "out_float = " + floating(3) + "; ";
      case 1:
        return "out_bool = " + boolean(3) + "; ";
      case 2:
        return "out_color = " + color(2) + "; ";
      case 3:
        return "in_float = " + floating(2) + "; ";
      case 4:
        return "in_bool = " + boolean(2) + "; ";
      case 5:
        return "in_color = " + color(2) + "; in_step = in_step == first ? second : first; ";
      case 6:
        return "stop(); ";
      case 7:
        return "walk(" + arguments("speed", "careful", "e") + "); ";
      default:
        return "o" + std::to_string(option_ + 1 + number(options - option_ - 1)) + "(" +
               arguments("v", "w", "u") + "); ";
    }
  }

  /// Some of the parameters, in any order.
  std::string arguments(const std::string& v, const std::string& w, const std::string& u) {
    std::string text;
    const auto add = [&](const std::string& argument) {
      if (chance(30)) return;
      text = chance(50) ? argument + (text.empty() ? "" : ", ") + text
                        : text + (text.empty() ? "" : ", ") + argument;
    };
    add(v + " = " + floating(2));
    add(w + " = " + boolean(2));
    add(u + " = " + color(1));
    return text;
  }

  std::string floating(int depth) {
    if (depth == 0 || chance(25)) {
      if (option_ > 0 && chance(20)) return "@v";
      return pick("x", "y", "0", "3", "0.5", "k", "state_time", "option_time", "out_float",
                  "in_float");
    }
    const std::string a = floating(depth - 1);
    switch (number(6)) {
      case 0:
        return "-(" + a + ")";
      case 1:
        return "(" + boolean(depth - 1) + " ? " + a + " : " + floating(depth - 1) + ")";
      case 2:
        return "f(" + arguments("a", "b", "e") + ")";
      default:
        return "(" + a + pick(" + ", " - ", " * ", " / ", " % ") + floating(depth - 1) + ")";
    }
  }

  std::string boolean(int depth) {
    if (depth == 0 || chance(15)) {
      if (option_ > 0 && chance(20)) return "@w";
      if (cooperative_ && chance(20)) return "conflict";
      return pick("p", "q", "true", "false", "out_bool", "in_bool", "action_done");
    }
    switch (number(7)) {
      case 0:
        return "!(" + boolean(depth - 1) + ")";
      case 1:
        return "(" + boolean(depth - 1) + " && " + boolean(depth - 1) + " && " + boolean(0) + ")";
      case 2:
        return "(" + boolean(depth - 1) + " || " + boolean(depth - 1) + ")";
      case 3:
        return "(" + color(depth - 1) + pick(" == ", " != ") +
               pick("color.red", "color.green", "c") + ")";
      case 4:
        return "g(a = " + floating(depth - 1) + ")";
      case 5:
        return "in_step == first";
      default:
        return "(" + floating(depth - 1) + pick(" < ", " <= ", " > ", " >= ", " == ", " != ") +
               floating(depth - 1) + ")";
    }
  }

  std::string color(int depth) {
    if (depth == 0 || chance(50)) {
      if (option_ > 0 && chance(20)) return "@u";
      return pick("c", "d", "out_color", "in_color", "color.red", "color.green", "color.blue");
    }
    if (chance(30)) return "h(e = " + color(depth - 1) + ", a = " + floating(1) + ")";
    return "(" + boolean(depth - 1) + " ? " + color(depth - 1) + " : " + color(depth - 1) + ")";
  }

  std::mt19937 random_;
  int option_ = 0;
  int states_ = 0;
  bool cooperative_ = false;
};

}  // namespace xabsl::test
