import {opening} from "./shell/work_store_opening";
import {mount} from "svelte";
import App from "./App.svelte";
import "./app.css";
import {read_view, soon} from "./shell/kept_view.svelte";
import {first_workbench, show_kept} from "./shell/start";
import {context_of} from "./state/context";
import {load_view} from "./kinds/view_dispatch";
import {load_texts} from "./texts/texts.svelte";

async function begin(): Promise<void> {
  const reading = read_view(),
    [view] = await Promise.all([soon(reading), opening]),
    workbench = first_workbench(view);
  await Promise.all([load_view(workbench.problem.task), load_texts()]);
  mount(App, {target: document.getElementById("app")!, context: context_of(workbench)});
  if (!view) show_kept(workbench, await reading);
}
void begin();
