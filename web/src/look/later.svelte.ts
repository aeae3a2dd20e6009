// What a first visit does without.
const parts: (() => Promise<unknown>)[] = [];
let at_rest = $state(false);

/** It comes when it is wanted, by what this returns; or once the page is at rest, for when its server is no more. */
export function later<T>(load: () => Promise<T>): () => Promise<T> {
  parts.push(load);
  return load;
}
/** The first view stands, and nothing waits for what is fetched now. What cannot be had is asked for again by whoever wants
 *  it. */
export async function come_to_rest(): Promise<void> {
  at_rest = true;
  await Promise.allSettled(parts.map((load) => load()));
}
/** Reactive. */
export function is_at_rest(): boolean {
  return at_rest;
}
