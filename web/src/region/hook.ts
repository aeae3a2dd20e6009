/** Adds to what tests see of the page. Later than the page's own start, which writes the hook anew. */
export function add_to_hook(things: Record<string, unknown>): void {
  queueMicrotask(() => {
    const page = globalThis as {__linkwright?: object};
    page.__linkwright = Object.assign(page.__linkwright ?? {}, things);
  });
}
