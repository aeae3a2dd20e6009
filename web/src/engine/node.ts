// The npm package in node: the engine's code comes from its files.
import {readFile} from "node:fs/promises";
import {code_urls, type CodePart} from "./code";
import {load_engine as load, type Code, type Engine} from "./index";
import {create_linkwright, type LinkwrightModule} from "./module";

export * from "./index";

async function code_here(): Promise<Code> {
  const compiled = async (part: CodePart) => WebAssembly.compile(await readFile(code_urls[part]));
  return {first: await compiled("first"), rest: await compiled("rest")};
}

export async function load_engine(code?: Code): Promise<Engine> {
  return load(code ?? (await code_here()));
}
/** What the engine asks: bindings/wasm/bind.cpp. */
export async function load_module(): Promise<LinkwrightModule> {
  return create_linkwright(await code_here());
}
