import {opening} from "./shell/work_store_opening";
import {mount} from "svelte";
import App from "./App.svelte";
import "./app.css";
import {first_workbench} from "./shell/start";
import {context_of} from "./state/context";
import {load_view} from "./tasks/views";
import {load_texts} from "./texts/texts.svelte";

async function begin(): Promise<void> {
  await opening;
  const workbench = first_workbench();
  await Promise.all([load_view(workbench.problem.task), load_texts()]);
  mount(App, {target: document.getElementById("app")!, context: context_of(workbench)});
}
void begin();
