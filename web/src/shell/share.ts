// A whole problem in the fragment of a link: #1.<check sum>.<data>, data = base64url of the deflated file.
import {Inflate, deflateSync, strFromU8, strToU8} from "fflate";
import {engine_text, type Problem} from "../state/problem";

export const longest_link = 64 * 1024; // characters, of the whole address
const most_bytes = 16 * 1024 * 1024; // of what it unpacks to
const most_packed = 2 * 1024 * 1024; // characters that are tried: nothing of use is packed thirtyfold, and packing takes time
const slice = 1024; // bytes unpacked at a time: at most a megabyte comes out before the next look at the sum
const version = "1";

export type LinkMistake = "damaged" | "too_long" | "newer" | "too_large";
export type Link = {text: string} | {mistake: LinkMistake};

const table = Uint32Array.from({length: 256}, (_, n) => {
  for (let k = 0; k < 8; ++k) n = n & 1 ? 0xedb88320 ^ (n >>> 1) : n >>> 1;
  return n >>> 0;
});
/** CRC-32: every change of up to four bytes in a row shows. */
export function check_sum(text: string): string {
  let sum = 0xffffffff;
  for (let i = 0; i < text.length; ++i) sum = table[(sum ^ text.charCodeAt(i)) & 255]! ^ (sum >>> 8);
  return ((sum ^ 0xffffffff) >>> 0).toString(16).padStart(8, "0");
}

function to_base64url(bytes: Uint8Array): string {
  let text = "";
  for (let i = 0; i < bytes.length; i += 4096) text += String.fromCharCode(...bytes.subarray(i, i + 4096));
  return btoa(text).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
}
function from_base64url(text: string): Uint8Array | null {
  if (!/^[A-Za-z0-9_-]*$/.test(text)) return null;
  try {
    return Uint8Array.from(atob(text.replace(/-/g, "+").replace(/_/g, "/")), (c) => c.charCodeAt(0));
  } catch {
    return null;
  }
}

/** The problem without what is too large for a link: the picture behind the drawing. */
export function without_picture(problem: Problem): Problem {
  if (!problem.view?.background) return problem;
  const {background: _, ...view} = problem.view;
  return {...problem, view};
}

/** The fragment, with its #. */
export function fragment_of(problem: Problem): string {
  const data = to_base64url(deflateSync(strToU8(JSON.stringify(without_picture(problem))), {level: 9}));
  return `#${version}.${check_sum(data)}.${data}`;
}
/** The address that opens this problem; nothing when it is too long for a link. */
export function link_of(problem: Problem, page: string): string | null {
  if (engine_text(problem).length > most_packed) return null;
  const link = page.replace(/#.*$/s, "") + fragment_of(problem);
  return link.length <= longest_link ? link : null;
}

/** Whether an address is one of this computer's: a link to it opens nowhere else. */
export function is_local({protocol, hostname}: Pick<URL, "protocol" | "hostname">): boolean {
  return protocol === "file:" || /^(localhost|.*\.localhost|127(\.\d+){3}|\[::1\]|0\.0\.0\.0)$/.test(hostname);
}

/** Unpacks, and stops where more comes out than a file may have. */
function inflated(bytes: Uint8Array): Link {
  const parts: Uint8Array[] = [];
  let sum = 0,
    ended = false;
  const stream = new Inflate((part, final) => {
    parts.push(part);
    sum += part.length;
    ended = final;
  });
  try {
    for (let at = 0; at < bytes.length; at += slice) {
      stream.push(bytes.subarray(at, at + slice), at + slice >= bytes.length);
      if (sum > most_bytes) return {mistake: "too_large"};
    }
  } catch {
    return {mistake: "damaged"};
  }
  if (!ended) return {mistake: "damaged"};
  const all = new Uint8Array(sum);
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return {text: strFromU8(all)};
}

/** What a link holds: the text of a problem file, not looked at yet. Nothing where it is no link of ours. */
export function read_fragment(fragment: string, page_length = 0): Link | null {
  const parts = /^#(\d+)\.(.*)$/s.exec(fragment);
  if (!parts) return fragment.length > 1 ? {mistake: "damaged"} : null;
  if (page_length + fragment.length > longest_link) return {mistake: "too_long"};
  if (parts[1] !== version) return {mistake: Number(parts[1]) > Number(version) ? "newer" : "damaged"};
  const [sum, data, ...more] = parts[2]!.split(".");
  if (data === undefined || more.length || check_sum(data) !== sum) return {mistake: "damaged"};
  const bytes = from_base64url(data);
  return bytes && bytes.length ? inflated(bytes) : {mistake: "damaged"};
}
