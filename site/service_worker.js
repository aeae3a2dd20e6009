// Keeps the whole workbench for offline use, a cache to each version (site/installable.py puts in version and files). Files
// under assets/ have their content's hash in their names, so that a cached one is never out of date; all others come from
// the network as long as there is one. Pages of the version before still find their files: its cache is kept.
const version = self.VERSION,
  files = self.FILES;
const ours = `linkwright ${registration.scope} `,
  name = ours + version;

async function our_caches() {
  return (await caches.keys()).filter((key) => key.startsWith(ours)); // the oldest first
}
async function forget_old() {
  const others = (await our_caches()).filter((key) => key !== name);
  await Promise.all(others.slice(0, -1).map((key) => caches.delete(key)));
}
async function store() {
  const cache = await caches.open(name);
  await cache.addAll(files.map((file) => new Request(file, {cache: file.startsWith("assets/") ? "default" : "no-cache"})));
}
addEventListener("install", (event) => event.waitUntil(store().then(() => skipWaiting())));
addEventListener("activate", (event) => event.waitUntil(forget_old().then(() => clients.claim())));

async function stored(request) {
  const options = {ignoreSearch: true};
  const newest = await (await caches.open(name)).match(request, options);
  if (newest) return newest;
  for (const key of await our_caches()) {
    const found = await (await caches.open(key)).match(request, options);
    if (found) return found;
  }
}
async function page_or_file(request) {
  const address = new URL(request.url);
  if (address.href === registration.scope) address.pathname += "index.html"; // the folder's own page
  const named = new Request(address.href);
  if (address.href.startsWith(`${registration.scope}assets/`)) return (await stored(named)) ?? fetch(request);
  try {
    return await fetch(request);
  } catch (offline) {
    const kept = await stored(named);
    if (!kept) throw offline;
    return kept;
  }
}
addEventListener("fetch", (event) => {
  const {request} = event;
  if (request.method === "GET" && request.url.startsWith(registration.scope)) event.respondWith(page_or_file(request));
});
