// Once the page has loaded: what is fetched for offline use does not delay it.
if ("serviceWorker" in navigator) addEventListener("load", () => void navigator.serviceWorker.register("./service_worker.js"));
