#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/ParseJson.h"
#include "xabsl/tools/server/Server.h"

/// For tests of the answers of a server about one text.
namespace xabsl::server {

using OutlineJson = nlohmann::json;

/// One declaration per line, so that a broken line affects at most one.
inline const std::string typedText = R"(/** Of the ball. */
namespace ball("Ball") {
  enum ball.color { orange, white };
  float input ball.x [0..100] "mm";
  bool input ball.seen;
  float input scaled(float value; bool both;);
  enum ball.color output ball.chosen;
  float internal memory;
  float const near = 150 "mm";
}
namespace walking("Walking") {
  behavior walk {
    float x;
    bool fast;
  }
  behavior stand { }
}
option search {
  float @x [0..1];
  bool @fast;
  initial state look {
    decision {
      if (ball.seen && @x > 2) goto run;
      else stay;
    }
    action {
      walk(x = @x, fast = true);
      memory = scaled(value = ball.x, both = false);
    }
  }
  state run {
    decision {
      if (state_time > 5) {
        if (@fast) goto look;
        else stay;
      } else goto look;
    }
    action { }
  }
}
option main {
  common decision {
    if (ball.seen) goto play;
  }
  common action {
    ball.chosen = orange;
  }
  initial target state begin {
    decision {
      else stay;
    }
    action {
      search option(x = 1, fast = true);
    }
  }
  target state play capacity 2 {
    decision {
      else goto begin;
    }
    action {
      stand();
    }
  }
}
agent main("Main", main);
)";

/// A server whose editor has one text open.
class OpenText {
 public:
  explicit OpenText(const std::string& text) {
    ask("initialize", OutlineJson::object());
    send({{"method", "textDocument/didOpen"},
          {"params", {{"textDocument", {{"uri", uri}, {"text", text}}}}}});
  }
  OutlineJson ask(const std::string& method, OutlineJson parameters) {
    parameters["textDocument"] = {{"uri", uri}};
    send({{"id", 1}, {"method", method}, {"params", parameters}});
    return answer_.at("result");
  }
  OutlineJson outline() { return ask("textDocument/documentSymbol", OutlineJson::object()); }

 private:
  static constexpr const char* uri = "file:///main.xabsl";
  void send(const OutlineJson& message) { server_.handle(message.dump()); }

  OutlineJson answer_;
  Server server_{
      {[](const std::string&, std::string&) { return std::optional<std::string>("none"); },
       [](const std::string&) { return std::vector<std::string>(); }},
      [this](const std::string& text) { answer_ = *gt::parseJsonAs<OutlineJson>(text, ""); }};
};

}  // namespace xabsl::server
