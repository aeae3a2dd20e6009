/** How often what is made of `read` has been made, the first time included. */
export function times_made(read: () => unknown): {readonly count: number; stop(): void} {
  let count = 0;
  const stop = $effect.root(() => {
    $effect(() => {
      read();
      ++count;
    });
  });
  return {
    get count() {
      return count;
    },
    stop,
  };
}
