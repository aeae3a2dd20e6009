import {opening} from "./shell/work_store_opening";
import {mount} from "svelte";
import App from "./App.svelte";
import "./app.css";
import {load_views} from "./tasks/views";
import {load_texts} from "./texts/texts.svelte";

void Promise.all([opening, load_views(), load_texts()]).then(() =>
  mount(App, {target: document.getElementById("app")!}),
);
