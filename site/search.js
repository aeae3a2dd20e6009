// The theme's search, taught Chinese: its words are not separated, so each run of Chinese characters is indexed from
// every character on, and a word asked for is found as the beginning of one. Stands in for the theme's worker, which it loads.
importScripts("theme_search.js");
const {lunr} = self;
const longest = 12; // characters of a run that are kept: as long as a term gets
const han = /\p{Script=Han}/u;

const plain_tokens = lunr.tokenizer;
lunr.tokenizer = (text, metadata) =>
  plain_tokens(text, metadata).flatMap((token) => {
    const characters = [...token.toString()];
    const starts = characters.flatMap((character, at) => (at === 0 || han.test(character) ? [at] : []));
    return starts.map((at) => token.clone(() => characters.slice(at, at + longest).join("")));
  });

// The original strips all that is not ASCII: Chinese words, and γ and τ.
lunr.trimmer = (token) => token.update((text) => text.replace(/^[^\p{L}\p{N}_]+|[^\p{L}\p{N}_]+$/gu, ""));
lunr.trimmer.label = "trimmer";
lunr.Pipeline.registeredFunctions.trimmer = lunr.trimmer;

const plain_search = lunr.Index.prototype.search;
lunr.Index.prototype.search = function (query) {
  const beginnings = query.replace(/\p{Script=Han}+/gu, (word) => [...word].slice(0, longest).join(""));
  return plain_search.call(this, beginnings.replace(/(\p{Script=Han})(?=\s|$)/gu, "$1*"));
};
