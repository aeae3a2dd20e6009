// What the builds leave in generated/ (script/build), for when they have not yet: their types are in module.ts and stored.ts.
declare module "*/generated/linkwright.mjs" {
  const create_linkwright: unknown;
  export default create_linkwright;
}
declare module "*/generated/thumbnails.json" {
  const thumbnails: object;
  export default thumbnails;
}
declare module "*/generated/stored.json" {
  const stored: unknown;
  export default stored;
}
