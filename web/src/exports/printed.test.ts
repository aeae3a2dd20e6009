// The printed sheet has a title and numbers of its own: the engine's are cut off its drawing.
import {beforeAll, expect, it} from "vitest";
import {load_module} from "../engine/node";
import type {Session} from "../engine/module";
import {examples} from "../gallery/gallery";
import {engine_text} from "../state/problem";
import {card_of} from "./take_away";

let session: Session;
beforeAll(async () => void (session = new (await load_module()).Session()));

it.each(["tailgate", "straight_watt_suspension", "wrist_orthosis"])(
  "title and numbers lie outside of the card: %s",
  (name) => {
    const {problem} = examples.find((example) => example.name === name)!;
    session.set_problem(engine_text(problem));
    const {tau} = (JSON.parse(session.best(1)) as {linkages: {tau: [number, number]}[]}).linkages[0]!,
      sheet = session.exported(...tau, "svg"),
      card = card_of(sheet);
    const [, top, , height] = /viewBox="([\d.]+) ([\d.]+) ([\d.]+) ([\d.]+)"/.exec(card)!.slice(1).map(Number);
    const rows = [...card.matchAll(/<text x="[\d.]+" y="([\d.]+)"[^>]*>([^<]*)/g)].map(([, y, words]) => ({
      y: Number(y),
      words: words!,
    }));
    const all = [problem.title!.slice(0, 12), "coupler"];
    for (const said of name === "wrist_orthosis" ? all.slice(0, 1) : all) {
      // on the ball the links are named in the drawing itself
      const found = rows.filter(({words}) => words.includes(said));
      expect(found.length, said).toBeGreaterThan(0);
      for (const {y} of found) expect(y < top! || y > top! + height!, said).toBe(true);
    }
    expect(card.length).toBeGreaterThan(sheet.length - 40);
  },
);
