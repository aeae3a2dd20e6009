// Keeps the whole workbench for offline use, a cache to each version (site/installable.py puts in version and files). As long
// as the server answers, all comes from there, so that no page is older than its server's; what the server has no more, a page
// of the version before still finds here, since its cache is kept.
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
  await cache.addAll(files.map((file) => new Request(file, {cache: "no-cache"})));
}
addEventListener("install", (event) => event.waitUntil(store().then(() => skipWaiting())));
addEventListener("activate", (event) => event.waitUntil(forget_old().then(() => clients.claim())));

/** What is kept under an address: of the newest version that has it. */
async function kept(address) {
  if (address === registration.scope) return kept(address + "index.html"); // the folder's own page
  for (const key of [name, ...(await our_caches())]) {
    const found = await (await caches.open(key)).match(address, {ignoreSearch: true});
    if (found) return found;
  }
}
async function answer(request) {
  const fetched = await fetch(request).catch(() => null);
  return fetched?.ok ? fetched : ((await kept(request.url.replace(/[?#].*$/, ""))) ?? fetched ?? Response.error());
}
addEventListener("fetch", (event) => {
  const {request} = event;
  if (request.method === "GET" && request.url.startsWith(registration.scope)) event.respondWith(answer(request));
});
