#include "xabsl/tools/documentation/Documentation.h"

#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/File.h"
#include "xabsl/tools/documentation/Charts.h"
#include "xabsl/tools/documentation/Graphviz.h"
#include "xabsl/tools/documentation/Html.h"
#include "xabsl/tools/documentation/PageFiles.h"
#include "xabsl/tools/documentation/Pages.h"

namespace xabsl {

namespace {

using namespace documentation;

/// Writes the files of one documentation.
class Writer {
 public:
  Writer(const Model& model, const std::string& folder)
      : model_(model), folder_(folder), usage_(model), links_(model) {}

  std::optional<Diagnostic> run() {
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    if (error) return problem(folder_, "cannot make the folder");
    charts_ = describeCharts(model_, usage_, links_);
    std::vector<std::string*> graphs;
    charts_.forEachList([&](std::vector<std::string>& list) {
      for (std::string& graph : list) graphs.push_back(&graph);
    });
    if (const auto failure = draw(graphs, folder_)) return problem(folder_, *failure);
    writePages();
    write("style.css", std::string(style()));
    write("search.js", std::string(script()));
    return failure_;
  }

 private:
  static Diagnostic problem(const std::string& file, const std::string& message) {
    return {Diagnostic::Severity::error, file, 0, 0, message};
  }

  void writePages() {
    const Content content{model_, usage_, links_, charts_};
    page("index.html", "Overview", overviewPage(content));
    for (int i = 0; i < static_cast<int>(model_.agents.size()); ++i)
      page(links_.agent(i), model_.agents[at(i)].name, agentPage(content, i));
    for (int i = 0; i < static_cast<int>(model_.options.size()); ++i)
      page(links_.option(i), model_.options[at(i)].name, optionPage(content, i));
    if (holdsAnything(model_, -1)) page(links_.space(-1), "none", namespacePage(content, -1));
    for (int i = 0; i < static_cast<int>(model_.namespaces.size()); ++i)
      page(links_.space(i), model_.namespaces[at(i)].name, namespacePage(content, i));
    write("entries.js", searchEntries(content));
  }

  void page(const std::string& file, const std::string& name, const std::string& content) {
    const std::string title = model_.title.empty() ? "XABSL" : model_.title;
    write(file,
          "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
              escaped(name + " – " + title) +
              "</title>\n<link rel=\"stylesheet\" href=\"style.css\">\n</head>\n<body>\n"
              "<header><a class=\"home\" href=\"index.html\">" +
              escaped(title) +
              "</a><div class=\"search\"><input type=\"search\" id=\"search\" "
              "placeholder=\"Search\" aria-label=\"Search\" autocomplete=\"off\">"
              "<ul id=\"found\" hidden></ul></div></header>\n<main>\n" +
              content +
              "</main>\n<script src=\"entries.js\"></script>\n"
              "<script src=\"search.js\"></script>\n</body>\n</html>\n");
  }

  void write(const std::string& name, const std::string& text) {
    if (failure_) return;
    const std::string path = folder_ + "/" + name;
    if (const auto done = gt::writeFile(path, text); !done)
      failure_ = problem(path, done.error().what);
  }

  const Model& model_;
  const std::string folder_;
  const Usage usage_;
  const Links links_;
  Charts charts_;
  std::optional<Diagnostic> failure_;
};

}  // namespace

std::optional<Diagnostic> writeDocumentation(const Model& model, const std::string& folder) {
  return Writer(model, folder).run();
}

}  // namespace xabsl
