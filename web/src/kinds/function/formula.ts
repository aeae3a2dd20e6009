// Where a formula stops making sense, read off the engine's sentence.

/** The part of a formula that was understood, and the rest; null where the sentence names no place. */
export function wrong_from(message: string, formula: string): {right: string; rest: string} | null {
  const at = /from character (\d+) on/.exec(message);
  if (!at) return null;
  const characters = [...formula],
    understood = Number(at[1]) - 1;
  return {right: characters.slice(0, understood).join(""), rest: characters.slice(understood).join("")};
}
