import {mount} from "svelte";
import App from "./App.svelte";
import "./app.css";
import {load_views} from "./tasks/views";

void load_views().then(() => mount(App, {target: document.getElementById("app")!}));
