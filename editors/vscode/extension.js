// Starts the language server of the program xabsl for the files of the language.
const { workspace } = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

exports.activate = () => {
  const command = workspace.getConfiguration("xabsl").get("program");
  client = new LanguageClient("xabsl", "XABSL", { command, args: ["lsp"] }, {
    documentSelector: [{ language: "xabsl" }, { language: "xml", scheme: "file" }],
    synchronize: { fileEvents: workspace.createFileSystemWatcher("**/*.{xabsl,xml}") },
  });
  return client.start();
};

exports.deactivate = () => client?.stop();
