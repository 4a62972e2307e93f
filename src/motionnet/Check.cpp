#include "motionnet/Check.h"

namespace motionnet {
namespace {

/// The net while one motion is requested: each node has one successor.
class Walk {
 public:
  Walk(const Net& net, int requested) : net_(net), requested_(requested) {
    state_.assign(net.nodes.size(), State::unknown);
  }

  enum class State : char { unknown, onPath, reaches, runsOut, loopsWithoutData, staysAway };

  /// What becomes of the walk from a node.
  State from(int node) {
    std::vector<int> path;
    State end = State::unknown;
    for (int n = node; end == State::unknown; n = next(n)) {
      const auto known = at(n);
      if (known == State::onPath)
        end = loop(n);
      else if (known != State::unknown)
        end = known;
      else if (arrived(n))
        end = State::reaches;
      else if (net_.nodes[static_cast<std::size_t>(n)].kind == Node::Kind::leave)
        end = State::runsOut;
      at(n) = end == State::unknown ? State::onPath : end;
      if (end == State::unknown) path.push_back(n);
    }
    for (const int n : path) at(n) = end;
    return end;
  }

  int next(int n) const {
    const auto& node = net_.nodes[static_cast<std::size_t>(n)];
    const bool follows =
        node.kind == Node::Kind::transition && (node.requested < 0 || node.requested == requested_);
    return follows ? node.target : n + 1;
  }

 private:
  State& at(int n) { return state_[static_cast<std::size_t>(n)]; }

  /// A request is fulfilled when the walk comes to data of the motion, that of extern when it
  /// leaves the net.
  bool arrived(int n) const {
    const auto& node = net_.nodes[static_cast<std::size_t>(n)];
    if (node.motion != requested_) return false;
    return node.kind == (requested_ == Net::externMotion ? Node::Kind::leave : Node::Kind::data);
  }

  State loop(int start) const {
    int n = start;
    do {
      if (net_.nodes[static_cast<std::size_t>(n)].kind == Node::Kind::data) return State::staysAway;
      n = next(n);
    } while (n != start);
    return State::loopsWithoutData;
  }

  const Net& net_;
  int requested_;
  std::vector<State> state_;
};

class Checker {
 public:
  Checker(const Net& net, const std::vector<std::string>& files) : net_(net), files_(files) {}

  std::vector<Diagnostic> check() {
    for (int requested = 0; requested < static_cast<int>(net_.motions.size()); ++requested) {
      Walk walk{net_, requested};
      checkStart(walk, requested);
      std::vector<char> reported(net_.motions.size(), 0);
      for (int n = 0; n < static_cast<int>(net_.nodes.size()); ++n)
        checkNode(walk, requested, n, reported);
    }
    checkReached();
    return std::move(errors_);
  }

 private:
  const Node& node(int n) const { return net_.nodes[static_cast<std::size_t>(n)]; }
  const std::string& name(int motion) const {
    return net_.motions[static_cast<std::size_t>(motion)];
  }
  void error(const Node& where, int line, std::string field, std::string message) {
    errors_.push_back({files_[static_cast<std::size_t>(where.motion)], line, std::move(field),
                       std::move(message)});
  }

  /// From the entry a motion must come to its own data.
  void checkStart(Walk& walk, int requested) {
    if (walk.from(net_.entry) != Walk::State::reaches)
      error(node(net_.entry), 0, "transition " + name(requested),
            "missing: the motion cannot be entered");
  }

  /// The walk rests on data only, so the checks begin there. One message for each pair of motions
  /// is enough.
  void checkNode(Walk& walk, int requested, int n, std::vector<char>& reported) {
    const Node& from = node(n);
    if (from.kind != Node::Kind::data || reported[static_cast<std::size_t>(from.motion)]) return;
    const auto state = walk.from(walk.next(n));
    if (state == Walk::State::reaches) return;
    reported[static_cast<std::size_t>(from.motion)] = 1;
    const std::string field = "transition " + name(requested);
    if (state == Walk::State::runsOut)
      error(from, from.line, field,
            "missing: from here the motion's end is reached while " + name(requested) +
                " is requested");
    else if (state == Walk::State::loopsWithoutData)
      error(from, from.line, field, "leads into an endless loop without data");
    else
      error(from, from.line, field,
            "missing: " + name(requested) + " is never reached from here, only a loop");
  }

  /// Every line must be reached from the entry, under whatever requests.
  void checkReached() {
    if (!errors_.empty()) return;
    std::vector<char> reached(net_.nodes.size(), 0);
    std::vector<int> open{net_.entry};
    while (!open.empty()) {
      const int n = open.back();
      open.pop_back();
      if (reached[static_cast<std::size_t>(n)]) continue;
      reached[static_cast<std::size_t>(n)] = 1;
      const Node& at = node(n);
      if (at.kind == Node::Kind::transition) open.push_back(at.target);
      const bool goesOn =
          at.kind != Node::Kind::leave && !(at.kind == Node::Kind::transition && at.requested < 0);
      if (goesOn) open.push_back(n + 1);
    }
    for (std::size_t n = 0; n < net_.nodes.size(); ++n)
      if (!reached[n] && net_.nodes[n].kind != Node::Kind::leave)
        error(net_.nodes[n], net_.nodes[n].line, "", "this line is never reached");
  }

  const Net& net_;
  const std::vector<std::string>& files_;
  std::vector<Diagnostic> errors_;
};

}  // namespace

std::vector<Diagnostic> check(const Net& net, const std::vector<std::string>& files) {
  return Checker{net, files}.check();
}

}  // namespace motionnet
