import {expect, it} from "vitest";
import {first_example} from "../gallery/gallery";
import {with_view} from "../state/problem";
import {question_of, type Target} from "./take_away";

it("asks for another drawing when the unit changes, and for none when the view does", () => {
  const target: Target = {pin: null, tau: [0.5, 1.25], type: "crank_rocker", problem: first_example.problem};
  const inches = {...target, problem: {...target.problem, length_unit: "in"}};
  expect(question_of(inches)).not.toBe(question_of(target));
  expect(question_of({...target, tau: [0.5, 1.26]})).not.toBe(question_of(target));
  expect(question_of({...target, problem: with_view(target.problem, {traced: [[1, 2]]})})).toBe(question_of(target));
});
