// The npm package, from the files that the page is built from: src/engine, src/contract, and the types that kinds of tasks add to it.
// usage: node npm/pack.mjs FOLDER     writes FOLDER/linkwright-<version>.tgz
import {execFileSync} from "node:child_process";
import {copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {dirname, join, relative, resolve} from "node:path";
import {fileURLToPath} from "node:url";
import ts from "typescript";

const root = fileURLToPath(new URL("../../", import.meta.url)),
  source = join(root, "web/src");
const target = resolve(process.argv[2] ?? "."),
  folder = join(target, "package");
const [, version] = /^project\(linkwright VERSION ([0-9.]+)/m.exec(readFileSync(join(root, "CMakeLists.txt"), "utf8"));
const kinds = readdirSync(join(source, "tasks"), {recursive: true, encoding: "utf8"})
  .filter((file) => file.endsWith("/replies.ts"))
  .map((file) => `tasks/${file}`)
  .sort();

function write(path, text) {
  mkdirSync(dirname(join(folder, path)), {recursive: true});
  writeFileSync(join(folder, path), text);
}
/** Names of modules as every host resolves them: with their endings. */
const with_endings = (text) =>
  text
    .replace(/\b(from|import|module) "(\.[^"]*?)(\.ts)?"/g, (all, word, path) =>
      /\.(mjs|js)$/.test(path) ? all : `${word} "${path}.js"`,
    )
    .replace(/new URL\("(\.[^"]+)\.ts"/g, 'new URL("$1.js"');

/** Script of the engine, types of all that these types name. */
function emit() {
  const {config} = ts.readConfigFile(join(root, "web/tsconfig.json"), ts.sys.readFile);
  const {options} = ts.parseJsonConfigFileContent({...config, include: []}, ts.sys, join(root, "web"));
  const files = [
    "engine/index.ts",
    "engine/node.ts",
    "engine/worker.ts",
    "engine/linkwright.d.ts",
    "state/problem.ts",
    ...kinds,
  ];
  const program = ts.createProgram(
    files.map((file) => join(source, file)),
    {...options, noEmit: false, allowJs: false, declaration: true, rootDir: source, outDir: folder, types: ["node"]},
  );
  const result = program.emit(undefined, (file, text) => {
    const path = relative(folder, file);
    if (path.endsWith(".d.ts") || /^(engine|contract)\//.test(path)) write(path, with_endings(text));
  });
  const mistakes = [...ts.getPreEmitDiagnostics(program), ...result.diagnostics];
  if (mistakes.length === 0) return;
  console.error(ts.formatDiagnostics(mistakes, ts.createCompilerHost(options)));
  process.exit(1);
}

process.chdir(join(root, "web")); // where the compiler looks for types
rmSync(folder, {recursive: true, force: true});
emit();
write(
  "index.d.ts",
  [
    'export * from "./engine/index.js";',
    'export type {Problem} from "./state/problem.js";',
    ...kinds.map((file) => `import "./${file.replace(/\.ts$/, ".js")}";`),
    "",
  ].join("\n"),
);
const {name, ...rest} = JSON.parse(readFileSync(new URL("package.json", import.meta.url), "utf8"));
write("package.json", `${JSON.stringify({name, version, ...rest}, null, 2)}\n`);
for (const file of ["README.md", "NOTICE"]) copyFileSync(new URL(file, import.meta.url), join(folder, file));
copyFileSync(join(root, "LICENSE"), join(folder, "LICENSE"));
mkdirSync(join(folder, "engine/generated"));
for (const file of ["linkwright.mjs", "first.wasm", "rest.wasm"])
  copyFileSync(join(source, "engine/generated", file), join(folder, "engine/generated", file));
execFileSync("npm", ["pack", "--silent", "--pack-destination", target, folder], {
  stdio: ["ignore", "inherit", "inherit"],
});
