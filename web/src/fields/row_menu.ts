// In a table of numbers Tab goes from number to number: what else a row has is in its menu, which the keyboard opens from
// any of its cells as it opens menus everywhere.

/** To be told to people (aria-keyshortcuts). */
export const menu_key = "Shift+F10";

export function opens_menu(event: KeyboardEvent): boolean {
  return event.key === "ContextMenu" || (event.shiftKey && event.key === "F10");
}
/** Where the menu of a row stands that was opened from one of its cells. */
export function below(event: KeyboardEvent): {x: number; y: number} {
  const {left, bottom} = (event.target as HTMLElement).getBoundingClientRect();
  return {x: left, y: bottom};
}
