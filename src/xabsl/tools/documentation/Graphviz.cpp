#include "xabsl/tools/documentation/Graphviz.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>

namespace xabsl::documentation {

namespace {

/// Runs dot without a shell; true if it succeeded. Of several graphs in a file it writes only the
/// first to the file of `-o`, so its output is redirected.
bool runDot(std::string source, const std::string& drawing) {
  std::string program = "dot", format = "-Tsvg";
  const std::array<char*, 4> arguments = {program.data(), format.data(), source.data(), nullptr};
  posix_spawn_file_actions_t files;
  if (posix_spawn_file_actions_init(&files) != 0) return false;
  constexpr int writing = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, drawing.c_str(), writing, 0644);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int spawned =
      posix_spawnp(&child, program.c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  int status = -1;
  return spawned == 0 && waitpid(child, &status, 0) == child && status == 0;
}

/// Removes the next SVG element from the beginning of dot's output and returns it.
std::string_view nextDrawing(std::string_view& text) {
  constexpr std::string_view close = "</svg>";
  const std::size_t begin = text.find("<svg"), end = text.find(close);
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) return {};
  const std::string_view drawing = text.substr(begin, end + close.size() - begin);
  text.remove_prefix(end + close.size());
  return drawing;
}

/// Removes all parts of a text between two marks, which may occur many times.
std::string without(std::string_view text, std::string_view begin, std::string_view end) {
  std::string result;
  for (;;) {
    const std::size_t first = text.find(begin);
    const std::size_t last =
        first == std::string_view::npos ? first : text.find(end, first + begin.size());
    result += text.substr(0, last == std::string_view::npos ? last : first);
    if (last == std::string_view::npos) return result;
    text.remove_prefix(last + end.size());
  }
}

/// Removes identifiers and titles, which are useless in a page with several charts.
std::string forPage(std::string_view drawing) {
  return without(without(without(drawing, "<!--", "-->\n"), "<title>", "</title>\n"), " id=\"",
                 "\"");
}

}  // namespace

std::optional<std::string> draw(const std::vector<std::string*>& graphs,
                                const std::string& folder) {
  const std::string source = folder + "/charts.dot", drawing = folder + "/charts.svg";
  std::ofstream out(source, std::ios::binary);
  for (const std::string* graph : graphs) out << *graph;
  out.close();
  if (!out) return "cannot write the file '" + source + "'";
  const bool drawn = runDot(source, drawing);
  std::ifstream in(drawing, std::ios::binary);
  const std::string all(std::istreambuf_iterator<char>(in), {});
  in.close();
  std::error_code ignored;
  std::filesystem::remove(source, ignored);
  std::filesystem::remove(drawing, ignored);
  const std::string problem = "Graphviz's program dot is missing or failed";
  if (!drawn) return problem;
  std::string_view rest = all;
  for (std::string* graph : graphs) {
    if (graph->empty()) continue;
    const std::string_view svg = nextDrawing(rest);
    if (svg.empty()) return problem;
    *graph = forPage(svg);
  }
  return std::nullopt;
}

}  // namespace xabsl::documentation
