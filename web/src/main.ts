import {mount} from "svelte";
import App from "./App.svelte";
import "./app.css";
import {open_work_store} from "./shell/work_store";
import {load_views} from "./tasks/views";

void Promise.all([open_work_store(), load_views()]).then(() => mount(App, {target: document.getElementById("app")!}));
