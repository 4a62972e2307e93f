// Reads the soccer behavior with the grammar as VS Code does, and checks what its words are.
//
//   scripts/run-node build/node/editors tests/editors grammar.mjs
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { createRequire } from "node:module";

const require = createRequire(import.meta.url);
const { loadWASM, OnigScanner, OnigString } = require("vscode-oniguruma");
const { INITIAL, Registry, parseRawGrammar } = require("vscode-textmate");
await loadWASM(readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm")).buffer);
const path = "editors/vscode/syntaxes/xabsl.tmLanguage.json";
const grammar = await new Registry({
  onigLib: Promise.resolve({ createOnigScanner: (p) => new OnigScanner(p), createOnigString: (s) => new OnigString(s) }),
  loadGrammar: async () => parseRawGrammar(readFileSync(path, "utf8"), path),
}).loadGrammar("source.xabsl");

/// The words of a text, each with its innermost scope.
function words(text) {
  let stack = INITIAL;
  return text.split("\n").flatMap((line) => {
    const { tokens, ruleStack } = grammar.tokenizeLine(line, stack);
    stack = ruleStack;
    return tokens.map(({ startIndex, endIndex, scopes }) => [line.slice(startIndex, endIndex), scopes.at(-1)]);
  });
}

const files = ["behavior/symbols/kick_symbols.xabsl", "behavior/options/ball/kick.xabsl"];
const scopes = new Map(files.flatMap((file) => words(readFileSync(file, "utf8"))));
for (const [word, scope] of Object.entries({
  option: "keyword.control", kick: "entity.name.type", enum: "storage.type", "@id": "variable.parameter",
  target: "keyword.control", "2000": "constant.numeric", state_time: "constant.language",
  perform_special_action: "entity.name.function", "motion.special_action": "variable.other", "||": "keyword.operator",
})) assert.equal(scopes.get(word), `${scope}.xabsl`, word);
assert.ok([...scopes].some(([word, scope]) => /Performs/.test(word) && scope === "comment.block.documentation.xabsl"));

// Nothing but blanks and brackets is left without a scope, in the whole behavior.
for (const file of readdirSync("behavior", { recursive: true }).filter((name) => name.endsWith(".xabsl")))
  for (const [word, scope] of words(readFileSync(`behavior/${file}`, "utf8")))
    if (scope === "source.xabsl") assert.match(word, /^[\s{}(),;]*$/, `${file}: ${word}`);
console.log("The grammar knows all words of the behavior");
