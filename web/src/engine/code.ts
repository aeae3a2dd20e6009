// Where the two modules of the engine's code are, beside the script (scripts/split_engine.mjs).
export const code_urls = {
  first: new URL("./generated/first.wasm", import.meta.url),
  rest: new URL("./generated/rest.wasm", import.meta.url),
};
export type CodePart = keyof typeof code_urls;

const compiled: Partial<Record<CodePart, Promise<WebAssembly.Module>>> = {};

/** Compiled once, for whoever asks; once more where it could not be had. */
export function compile(part: CodePart): Promise<WebAssembly.Module> {
  return (compiled[part] ??= fetched(code_urls[part]).catch((error: unknown) => {
    delete compiled[part];
    throw error;
  }));
}
async function fetched(url: URL): Promise<WebAssembly.Module> {
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.pathname}: ${response.status} ${response.statusText}`);
  const is_named = response.headers.get("Content-Type") === "application/wasm"; // not every host knows it
  return is_named ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
