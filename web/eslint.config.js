// Faults that the compiler does not see, and who may import whom. Layout is Prettier's; circles of imports, and that the
// frame knows no kind of task, are src/layers.test.ts's.
import js from "@eslint/js";
import svelte from "eslint-plugin-svelte";
import globals from "globals";
import tseslint from "typescript-eslint";
import svelte_config from "./svelte.config.js";

/** These files import what matches from nowhere. */
function layer(files, regex, message) {
  return {
    files,
    ignores: ["**/*.test.ts"],
    rules: {"no-restricted-imports": ["error", {patterns: [{regex, message}]}]},
  };
}

// What Svelte tears down reads the state as it was before: to act on it, let that be over (queueMicrotask).
const torn_down =
    ':matches(CallExpression[callee.name="$effect"] ReturnStatement > ArrowFunctionExpression, CallExpression[callee.name="$effect"] > ArrowFunctionExpression > ArrowFunctionExpression, CallExpression[callee.name="onDestroy"] > ArrowFunctionExpression)',
  at_once = [
    " >",
    " > BlockStatement > ExpressionStatement >",
    " > BlockStatement > IfStatement > ExpressionStatement >",
  ],
  acts = [
    'CallExpression[callee.object.name="workbench"]',
    'AssignmentExpression[left.object.name="workbench"]',
    'AssignmentExpression[left.object.object.name="workbench"]',
  ];
const no_act_in_teardown = at_once.flatMap((path) =>
  acts.map((act) => ({
    selector: `${torn_down}${path} ${act}`,
    message: "What is torn down sees the state as it was: act afterwards (queueMicrotask).",
  })),
);

// A type of ours that is called as one of the browser's or the language's is taken for it where its import is missing.
const shadowed =
    "Array|Blob|Document|Element|Event|File|History|Image|Location|Map|Node|Number|Object|Option|Plugin|Range|Request|Response|Selection|Set|Storage|String|Symbol|Text|Window",
  no_shadow = ["TSInterfaceDeclaration", "TSTypeAliasDeclaration", "ClassDeclaration"].map((kind) => ({
    selector: `${kind}[id.name=/^(${shadowed})$/]`,
    message: "A global has this name.",
  }));

export default tseslint.config(
  {ignores: ["node_modules/", "public/", "src/engine/generated/", "npm/consumer/"]},
  js.configs.recommended,
  tseslint.configs.recommended,
  svelte.configs.recommended,
  {
    rules: {
      "@typescript-eslint/no-unused-vars": ["error", {varsIgnorePattern: "^_", argsIgnorePattern: "^_"}],
      "no-restricted-syntax": ["error", ...no_act_in_teardown, ...no_shadow],
      "no-control-regex": "off", // files are told apart by their first bytes
      "svelte/no-unused-svelte-ignore": "off", // it does not see the warnings on accessibility that svelte-check has
    },
  },
  {
    files: ["**/*.svelte", "**/*.svelte.ts"],
    languageOptions: {
      globals: globals.browser,
      parserOptions: {parser: tseslint.parser, svelteConfig: svelte_config},
    },
  },
  // Rules that need types: where they do not cost minutes.
  {
    files: ["**/*.ts"],
    ignores: ["**/*.svelte.ts"],
    languageOptions: {parserOptions: {projectService: true}},
    rules: {
      "@typescript-eslint/await-thenable": "error",
      "@typescript-eslint/no-floating-promises": "error",
      "@typescript-eslint/no-for-in-array": "error",
      "@typescript-eslint/no-misused-promises": "error",
    },
  },
  {files: ["**/*.ts", "**/*.svelte"], rules: {"no-undef": "off"}}, // the compiler's
  {files: ["e2e/**", "site/**", "tests/**"], rules: {"@typescript-eslint/no-explicit-any": "off"}}, // what the page hands over
  {files: ["scripts/*.mjs", "npm/**/*.mjs", "*.js"], languageOptions: {globals: globals.node}},
  {files: ["firefox/*.mjs", "npm/*.test.mjs"], languageOptions: {globals: {...globals.node, ...globals.browser}}}, // parts run in the page

  layer(["src/contract/**"], "^\\.\\./", "What page and engine say to each other knows neither."),
  layer(["src/engine/**"], "^\\.\\./(?!texts/|contract/)", "The engine's client and worker know nothing of the page."),
  layer(["src/questions/**"], "^\\.\\./(?!engine/)", "Questions know of nothing but the engine's client."),
  layer(
    ["src/fields/**"],
    "/(state/(?!task|shape)|kinds|drawing|region|shell/(?!single_keys))",
    "A field hears of the page by edited.ts.",
  ),
  layer(
    ["src/texts/*.svelte.ts", "src/texts/numbers.ts"],
    "/(?!state/preferences|contract/messages)[a-z_]+/",
    "Words know of nothing but their language.",
  ),
  layer(
    ["src/state/**"],
    "/(drawing|region|task|requirements|numbers|pins|transport|solid|exports|best|terms|fields|shell)/",
    "The state knows no view.",
  ),
);
