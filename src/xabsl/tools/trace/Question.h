#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "xabsl/language/Diagnostic.h"
#include "xabsl/language/Model.h"
#include "xabsl/tools/trace/Moment.h"

namespace xabsl {

/// An expression of XABSL about a moment of a behavior. Names that it may use besides the symbols:
///
///     OPTION               its active state: `handle_ball == align`
///     OPTION.previous      the one in the cycle before: so transitions can be asked for
///     OPTION.active        whether it is active
///     OPTION.time, OPTION.state_time      in ms
///     BEHAVIOR             whether a basic behavior is executed
///     OPTION.PARAMETER, BEHAVIOR.PARAMETER
///     time                 of the cycle, in ms
///
/// An inactive option equals none of its states. Symbols with parameters have the value that they
/// had last, whatever the arguments were.
class Question {
 public:
  /// Another name that an expression may use, with the source of its value.
  struct Variable {
    std::string name;
    Type type;
    const double* value;
  };
  struct Making;

  /// Compiles an expression of the given type; messages refer to its place in a file. The moment
  /// and the values of the variables must not move.
  static Making make(const Moment& moment, std::string_view expression, Type type,
                     const std::string& file, Location place,
                     const std::vector<Variable>& variables = {});

  Question(Question&&) noexcept;
  Question& operator=(Question&&) noexcept;
  ~Question();

  /// The present value, elements by their registered values; nothing if it depends on a symbol
  /// without a value.
  std::optional<double> answer();

 private:
  struct Inside;
  explicit Question(std::unique_ptr<Inside> inside);

  std::unique_ptr<Inside> inside_;
};

struct Question::Making {
  std::optional<Question> question;
  std::vector<Diagnostic> diagnostics;
};

}  // namespace xabsl
