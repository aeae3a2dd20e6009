/** What runs later (timers, frames) fails where what is drawn at once does: at the boundary around the component. Made
 *  in a component. */
export function guarded(): (work: () => void) => void {
  let failure = $state.raw<{error: unknown} | null>(null);
  $effect(() => {
    if (failure) throw failure.error;
  });
  return (work) => {
    try {
      work();
    } catch (error) {
      failure = {error};
    }
  };
}
