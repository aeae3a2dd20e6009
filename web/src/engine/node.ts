// The npm package in node: the module's bytes come from its file.
import {readFile} from "node:fs/promises";
import {load_engine as load, type Engine} from "./index";

export * from "./index";

export async function load_engine(options: {wasmBinary?: Uint8Array} = {}): Promise<Engine> {
  const file = new URL("./generated/linkwright.wasm", import.meta.url);
  return load({wasmBinary: options.wasmBinary ?? (await readFile(file))});
}
