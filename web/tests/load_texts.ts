// For all tests: both languages are there from the start.
import {preferences} from "../src/state/preferences.svelte";
import {load_texts} from "../src/texts/texts.svelte";

for (const language of ["zh", "en"] as const) {
  preferences.language = language;
  await load_texts();
}
