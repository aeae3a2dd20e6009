import {opening} from "./shell/work_store_opening";
import {mount} from "svelte";
import App from "./App.svelte";
import "./app.css";
import {load_views} from "./tasks/views";

void Promise.all([opening, load_views()]).then(() => mount(App, {target: document.getElementById("app")!}));
