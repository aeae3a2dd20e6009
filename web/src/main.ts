import {opening} from "./shell/work_store_opening";
import {mount} from "svelte";
import App from "./App.svelte";
import "./app.css";
import {read_view} from "./shell/kept_view.svelte";
import {first_workbench} from "./shell/start";
import {context_of} from "./state/context";
import {load_view} from "./kinds/view_dispatch";
import {load_texts} from "./texts/texts.svelte";

async function begin(): Promise<void> {
  const [view] = await Promise.all([read_view(), opening]),
    workbench = first_workbench(view);
  await Promise.all([load_view(workbench.problem.task), load_texts()]);
  mount(App, {target: document.getElementById("app")!, context: context_of(workbench)});
}
void begin();
