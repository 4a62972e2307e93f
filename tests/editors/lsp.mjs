// An editor's side of the language server: opens the soccer behavior, breaks it in an unsaved
// buffer, and asks all that the server offers.
//
//   scripts/run-node build/node/editors tests/editors lsp.mjs XABSL
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import rpc from "vscode-languageserver-protocol/node";

const child = spawn(process.argv[2], ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
const ended = new Promise((done) => child.on("exit", done));
const connection = rpc.createProtocolConnection(
  new rpc.StreamMessageReader(child.stdout), new rpc.StreamMessageWriter(child.stdin));

const diagnostics = new Map();
const waiting = [];
connection.onNotification(rpc.PublishDiagnosticsNotification.type, ({ uri, diagnostics: list }) => {
  diagnostics.set(uri, list);
  waiting.splice(0).forEach((check) => check());
});
/// Waits until the diagnostics of a file fulfil a condition.
const until = (uri, holds) => new Promise((done) => {
  const check = () => diagnostics.has(uri) && holds(diagnostics.get(uri)) ? done(diagnostics.get(uri)) : waiting.push(check);
  check();
});

const uriOf = (path) => pathToFileURL(resolve(path)).href;
const kick = uriOf("behavior/options/ball/kick.xabsl"), ball = uriOf("behavior/symbols/ball_symbols.xabsl");
const text = readFileSync("behavior/options/ball/kick.xabsl", "utf8");
/// The position behind (or with an offset, in) the n-th occurrence of a piece of text.
const at = (source, piece, offset = piece.length) => {
  const index = source.indexOf(piece);
  assert.notEqual(index, -1, piece);
  const lines = source.slice(0, index + offset).split("\n");
  return { line: lines.length - 1, character: lines.at(-1).length };
};
const ask = (type, position, uri = kick, more = {}) =>
  connection.sendRequest(type, { textDocument: { uri }, position, ...more });
const labels = async (source, piece, offset) => {
  change(source);
  return (await ask(rpc.CompletionRequest.type, at(source, piece, offset))).map((item) => item.label);
};
let version = 1;
const change = (source) => connection.sendNotification(rpc.DidChangeTextDocumentNotification.type,
  { textDocument: { uri: kick, version: ++version }, contentChanges: [{ text: source }] });
const open = (uri, source) => connection.sendNotification(rpc.DidOpenTextDocumentNotification.type,
  { textDocument: { uri, languageId: "xabsl", version: 1, text: source } });

connection.listen();
const { capabilities } = await connection.sendRequest(rpc.InitializeRequest.type,
  { processId: process.pid, rootUri: uriOf("."), capabilities: {} });
assert.equal(capabilities.positionEncoding, "utf-16");
connection.sendNotification(rpc.InitializedNotification.type, {});

// Diagnostics of unsaved buffers.
open(kick, text);
await until(kick, (list) => list.length === 0);
change(text.replace("goto going_on", "goto going_om"));
const [error] = await until(kick, (list) => list.length > 0);
assert.equal(error.severity, 1);
assert.match(error.message, /unknown state .going_om..*did you mean/);
assert.deepEqual(error.range.start, at(text, "goto going_on", 5));
change(text);
await until(kick, (list) => list.length === 0);

// How something is called, and which parameter comes next.
const signature = async (source, piece, offset) => {
  change(source);
  return ask(rpc.SignatureHelpRequest.type, at(source, piece, offset));
};
const called = text.replace("stand();", "go_to_point(y = max(a = 1, b = 2), x = 3, ");
const help = await signature(called, "x = 3, ");
assert.equal(help.signatures[0].label, "go_to_point(float x, float y, float angle, float max_speed)");
assert.equal(help.activeParameter, 2, "the first that is not set yet");
assert.equal((await signature(called, "go_to_point(y = ")).activeParameter, 1);
assert.equal(await signature(text, "option kick {"), null);
change(text);

// Files of XABSL 2.1 in XML, with what includes them; other XML is none of our business.
const moveAround = uriOf("src/xabsl/tests/data/report/Options/move-around.xml");
const moveAroundText = readFileSync(new URL(moveAround), "utf8");
open(moveAround, moveAroundText.replace("<decision-tree", "<decision-bush"));
const [wrong] = await until(moveAround, (list) => list.length > 0);
assert.equal(wrong.severity, 1);
open(moveAround, moveAroundText);
await until(moveAround, (list) => list.every(({ severity }) => severity > 1));
const xmlOutline = await connection.sendRequest(rpc.DocumentSymbolRequest.type, { textDocument: { uri: moveAround } });
assert.ok(xmlOutline.some(({ name }) => name === "move-around"));
const xmlFolds = () => connection.sendRequest(rpc.FoldingRangeRequest.type, { textDocument: { uri: moveAround } });
const wholeFolds = await xmlFolds();
// The last state is named nowhere but in this file; the first one also as the initial one, of which the server knows no place.
const renameInXml = (piece) => ask(rpc.RenameRequest.type, at(moveAroundText, piece), moveAround, { newName: "over" });
const over = await renameInXml('<state name="done');
assert.deepEqual(over.changes[moveAround].map(({ range }) => moveAroundText.split("\n")[range.start.line].slice(range.start.character, range.end.character)),
  Array(moveAroundText.split('"done"').length - 1).fill("done"));
await assert.rejects(renameInXml('<state name="go'), /unknown state 'go'/);
open(moveAround, moveAroundText.replace("</state>", "</stat"));
const openOutline = await connection.sendRequest(rpc.DocumentSymbolRequest.type, { textDocument: { uri: moveAround } });
const namesOf = (list) => list.map(({ name, children }) => [name, namesOf(children)]);
assert.deepEqual(namesOf(openOutline), namesOf(xmlOutline), "while an end tag is typed");
assert.ok(wholeFolds.length > 3 && (await xmlFolds()).length >= wholeFolds.length - 1);
const foreign = uriOf("foreign.xml");
open(foreign, "<project/>");
await until(foreign, (list) => list.length === 0);
for (const uri of [moveAround, foreign])
  connection.sendNotification(rpc.DidCloseTextDocumentNotification.type, { textDocument: { uri } });

// Definition, references, hover, highlights.
const definition = await ask(rpc.DefinitionRequest.type, at(text, "goto going_on", 7));
assert.deepEqual(definition, { uri: kick, range: { start: at(text, "state going_on", 6), end: at(text, "state going_on") } });
const parameter = await ask(rpc.ReferencesRequest.type, at(text, "== @id", 4), kick, { context: { includeDeclaration: true } });
assert.equal(parameter.filter(({ uri }) => uri === kick).length, text.split("@id").length - 1);
assert.ok(parameter.some(({ uri }) => uri.endsWith("handle_ball.xabsl")), "calls set it by name");
const special = await ask(rpc.ReferencesRequest.type, at(text, "motion.special_action", 3), kick, { context: { includeDeclaration: true } });
assert.ok(special.some(({ uri }) => uri.endsWith("robot_symbols.xabsl")));
const hover = await ask(rpc.HoverRequest.type, at(text, "motion.special_action", 3));
assert.match(hover.contents.value, /enum special_action input motion\.special_action/);
assert.match(hover.contents.value, /being executed/);
const ballText = readFileSync("behavior/symbols/ball_symbols.xabsl", "utf8");
const unit = await ask(rpc.HoverRequest.type, at(ballText, "ball.seen.x"), ball);
assert.match(unit.contents.value, /float input ball\.seen\.x "mm"/);
assert.ok((await ask(rpc.DocumentHighlightRequest.type, at(text, "goto done", 6))).length >= 3);

// Completion by context, in texts that are broken there.
assert.deepEqual((await labels(text.replace("goto going_on;", "goto "), "goto ")).sort(), ["begin", "done", "going_on"]);
assert.deepEqual(await labels(text.replace("== @id)", "== @)"), "== @"), ["@id"]);
const elements = await labels(text.replace("(id = none)", "(id = )"), "(id = )", 6);
assert.equal(elements[0], "none");
for (const name of ["stand", "push_strong"]) assert.ok(elements.includes(name), name);
assert.deepEqual(await labels(text.replace("perform_special_action(id = none)", "go_to_point("), "go_to_point("),
  ["x", "y", "angle", "max_speed"]);
const calls = await labels(text.replace("action { stand(); }", "action {  }"), "action {  }", 9);
for (const name of ["search_ball", "go_to_ball", "head_control_mode"]) assert.ok(calls.includes(name), name);
assert.ok(!calls.includes("ball.seen.x"));
const inputs = await labels(text.replace("state_time > 2000", "state_time > "), "state_time > ");
for (const name of ["ball.seen.x", "@id", "state_time"]) assert.ok(inputs.includes(name), name);
change(text);

// Rename, everywhere, and refused where it would change what the behavior means.
const renamed = await ask(rpc.RenameRequest.type, at(text, "goto going_on", 7), kick, { newName: "running" });
assert.deepEqual(Object.keys(renamed.changes), [kick]);
assert.equal(renamed.changes[kick].length, 2);
const option = await ask(rpc.RenameRequest.type, at(text, "option kick", 8), kick, { newName: "shoot" });
assert.ok(Object.keys(option.changes).some((uri) => uri.endsWith("handle_ball.xabsl")));
for (const newName of ["begin", "goto", "two words", ""])
  await assert.rejects(ask(rpc.RenameRequest.type, at(text, "goto going_on", 7), kick, { newName }));

// Outline and format.
const outline = await connection.sendRequest(rpc.DocumentSymbolRequest.type, { textDocument: { uri: kick } });
assert.deepEqual(outline.map(({ name }) => name), ["kick"]);
assert.deepEqual(outline[0].children.map(({ name }) => name), ["begin", "going_on", "done"]);
const folds = await connection.sendRequest(rpc.FoldingRangeRequest.type, { textDocument: { uri: kick } });
assert.ok(folds.some(({ startLine }) => startLine === at(text, "state going_on").line));

// Colors by meaning, also beside a line that is being typed.
const { legend } = capabilities.semanticTokensProvider;
const colors = async (source) => {
  change(source);
  const { data } = await connection.sendRequest(rpc.SemanticTokensRequest.type, { textDocument: { uri: kick } });
  const lines = source.split("\n"), found = [];
  for (let i = 0, line = 0, character = 0; i < data.length; i += 5) {
    character = data[i + 1] + (data[i] === 0 ? character : 0);
    line += data[i];
    found.push(`${lines[line].slice(character, character + data[i + 2])} ${legend.tokenTypes[data[i + 3]]}`);
  }
  return found;
};
for (const source of [text, text.replace("goto going_on;", "goto ")])
  for (const name of ["kick class", "going_on event", "id parameter", "motion.special_action variable", "stand function"])
    assert.ok((await colors(source)).includes(name), name);
change(text);
const options = { tabSize: 2, insertSpaces: true };
assert.deepEqual(await connection.sendRequest(rpc.DocumentFormattingRequest.type, { textDocument: { uri: kick }, options }), []);
change(text.replaceAll("  ", "\t"));
const [edit] = await connection.sendRequest(rpc.DocumentFormattingRequest.type, { textDocument: { uri: kick }, options });
assert.equal(edit.newText, text);

await connection.sendRequest(rpc.ShutdownRequest.type);
await connection.sendNotification(rpc.ExitNotification.type);
assert.equal(await ended, 0);
// An editor that is gone without a word, while another process holds the server's input.
const editor = spawn("true");
await new Promise((done) => editor.on("exit", done));
const left = spawn(process.argv[2], ["lsp"], { stdio: ["pipe", "ignore", "inherit"] });
const greeting = JSON.stringify({ jsonrpc: "2.0", id: 1, method: "initialize", params: { processId: editor.pid } });
left.stdin.write(`Content-Length: ${greeting.length}\r\n\r\n${greeting}`);
assert.equal(await new Promise((done) => left.on("exit", done)), 1);
console.log("The language server did all that it was asked");
