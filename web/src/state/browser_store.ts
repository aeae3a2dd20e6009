/** The browser's small store, read and written at once; nothing where it keeps nothing. */
export function browser_store(): Storage | null {
  try {
    return globalThis.localStorage ?? null;
  } catch {
    return null; // forbidden, as in some private windows
  }
}
