/** Strokes on a field of 24 × 24. */
export const icons = {
  undo: "M9 14 4 9l5-5M4 9h10a6 6 0 0 1 0 12h-3",
  redo: "m15 14 5-5-5-5M20 9H10a6 6 0 0 0 0 12h3",
  task: "M3.5 12h6v8h-6zM14.4 4l6.6 2.4-2.7 7.5-6.6-2.4z",
  limits: "M4 5h16l-6 8v6l-4 2v-8z",
  pins: "M8 3h8l-2 7 4 3H6l4-3zM12 13v8",
  examples: "M4 4h7v7H4zM13 4h7v7h-7zM4 13h7v7H4zM13 13h7v7h-7z",
  map: "M4 4h16v16H4zM4 20 20 4M12 4v16",
  numbers: "M4 6h16M4 12h10M4 18h13",
  theme: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zM12 3v18",
  add: "M12 5v14M5 12h14",
  close: "M6 6l12 12M18 6 6 18",
  down: "m7 10 5 5 5-5",
} as const;
export type IconName = keyof typeof icons;
