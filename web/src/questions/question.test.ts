import {afterEach, beforeEach, describe, expect, it, vi} from "vitest";
import {Crashed, Superseded} from "../engine/client";
import {Refusal} from "../engine/refusal";
import {patience_ms, Question} from "./question.svelte";
import {Questions} from "./questions";

/** A request that is answered when the test says so. */
function held<T>() {
  let resolve!: (value: T | null) => void, reject!: (reason: Error) => void;
  const reply = new Promise<T | null>((...ends) => ([resolve, reject] = ends));
  const request = vi.fn((_signal: AbortSignal) => reply);
  return {request, resolve, reject, signal: () => request.mock.calls[0]![0]};
}

describe("a question", () => {
  let questions: Questions, question: Question<string, number>;
  beforeEach(() => {
    questions = new Questions();
    question = new Question(questions);
    vi.useFakeTimers();
  });
  afterEach(() => void vi.useRealTimers());

  it("knows its answer, and of what it is", async () => {
    const a = held<number>();
    expect([question.value, question.of, question.busy, questions.settled()]).toEqual([null, null, false, true]);
    const answer = question.ask("a", a.request);
    expect([question.busy, question.is_asked("a"), question.is_of("a"), questions.settled()]).toEqual([
      true,
      true,
      false,
      false,
    ]);
    a.resolve(1);
    expect(await answer).toBe(1);
    expect([question.value, question.of, question.is_of("a"), question.busy, questions.settled()]).toEqual([
      1,
      "a",
      true,
      false,
      true,
    ]);
  });
  it("is asked once while it is on its way, and again when it has been answered", async () => {
    const a = held<number>();
    const both = [question.ask("a", a.request), question.ask("a", a.request)];
    a.resolve(1);
    expect(await Promise.all(both)).toEqual([1, 1]);
    expect(a.request).toHaveBeenCalledTimes(1);
    void question.ask("a", a.request);
    expect(a.request).toHaveBeenCalledTimes(2);
  });
  it("is superseded by the next, whose answer alone is taken; the last one stays until then", async () => {
    const a = held<number>(),
      b = held<number>();
    question.put("before", 0);
    const first = question.ask("a", a.request),
      second = question.ask("b", b.request);
    expect(a.signal().aborted).toBe(true);
    a.resolve(1);
    expect(await first).toBeNull();
    expect([question.value, question.of]).toEqual([0, "before"]);
    b.resolve(2);
    await second;
    expect([question.value, question.of]).toEqual([2, "b"]);
    expect(questions.settled()).toBe(true);
  });
  it("that follows takes late answers, too, until a newer one is there", async () => {
    const [a, b, c] = [held<number>(), held<number>(), held<number>()];
    const following = new Question<string, number>(questions, {follows: true});
    const answers = [following.ask("a", a.request), following.ask("b", b.request), following.ask("c", c.request)];
    a.resolve(1);
    await answers[0];
    expect([following.value, following.is_asked("c"), questions.settled()]).toEqual([1, true, false]);
    c.resolve(3);
    await answers[2];
    b.resolve(2);
    expect(await answers[1]).toBeNull();
    expect([following.value, following.busy, questions.settled()]).toEqual([3, false, true]);
    const late = held<number>();
    void following.ask("d", late.request);
    void following.ask("e", held<number>().request);
    following.forget();
    late.resolve(4);
    await vi.advanceTimersByTimeAsync(1);
    expect([following.value, following.busy, questions.settled()]).toEqual([null, false, true]);
  });
  it("shows what comes with its answer in the same moment", async () => {
    const a = held<number>(),
      taken = vi.fn((value: number) => void expect([question.value, value]).toEqual([1, 1]));
    const answer = question.ask("a", a.request, {taken});
    a.resolve(1);
    await answer;
    expect(taken).toHaveBeenCalledTimes(1);
  });
  it("takes an answer that comes otherwise in place of what is on its way", async () => {
    const a = held<number>(),
      answer = question.ask("a", a.request);
    question.put("b", 2);
    a.resolve(1);
    expect(await answer).toBeNull();
    expect([question.value, question.of]).toEqual([2, "b"]);
  });
  it("is stale where its answer has not been of the present for longer than patience", async () => {
    let present = "a";
    const about = new Question<string, number>(questions, {is_present: (of) => of === present});
    about.put("a", 1);
    present = "b";
    about.compare();
    await vi.advanceTimersByTimeAsync(patience_ms - 1);
    about.compare(); // does not begin to wait again
    expect([about.stale, about.is_of_present]).toEqual([false, false]);
    await vi.advanceTimersByTimeAsync(1);
    expect(about.stale).toBe(true);
    about.put("b", 2);
    expect([about.stale, about.is_of_present]).toEqual([false, true]);
    present = "c";
    about.compare();
    await vi.advanceTimersByTimeAsync(patience_ms - 1);
    about.put("between", 3); // an answer, if not of the present: patience begins anew
    await vi.advanceTimersByTimeAsync(patience_ms - 1);
    expect(about.stale).toBe(false);
    await vi.advanceTimersByTimeAsync(1);
    expect(about.stale).toBe(true);
    about.forget();
    expect(about.stale).toBe(false);
  });
  it("is not waited for where it is asked at leisure", async () => {
    const a = held<number>(),
      answer = question.ask("a", a.request, {at_leisure: true});
    expect([question.busy, questions.settled()]).toEqual([true, true]);
    a.resolve(1);
    expect(await answer).toBe(1);
  });
  it("tells why it has no answer: refused, died; not where another of its kind was asked", async () => {
    for (const [reason, error] of [
      [new Superseded(), null],
      [new Refusal([]), Refusal],
      [new Crashed("killed"), Crashed],
    ] as const) {
      const a = held<number>(),
        answer = question.ask("a", a.request);
      a.reject(reason);
      expect(await answer).toBeNull();
      expect(question.error).toEqual(error ? expect.any(error) : null);
      expect([question.busy, questions.settled()]).toEqual([false, true]);
    }
    question.put("b", 2);
    expect(question.error).toBeNull();
  });
  it("does not hide a mistake of ours", async () => {
    await expect(question.ask("a", () => Promise.reject(new TypeError("mistake")))).rejects.toThrow("mistake");
    expect([question.busy, questions.settled()]).toEqual([false, true]);
  });
  it("waits for rest, in which something else may be asked", async () => {
    const a = held<number>(),
      b = held<number>();
    void question.ask("a", a.request, {rest_ms: 100});
    await vi.advanceTimersByTimeAsync(60);
    void question.ask("a", a.request, {rest_ms: 100}); // goes on waiting
    await vi.advanceTimersByTimeAsync(39);
    expect([a.request.mock.calls.length, questions.settled()]).toEqual([0, false]);
    const answer = question.ask("b", b.request, {rest_ms: 100});
    await vi.advanceTimersByTimeAsync(100);
    expect([a.request.mock.calls.length, b.request.mock.calls.length]).toEqual([0, 1]);
    question.hold(); // too late
    b.resolve(2);
    expect(await answer).toBe(2);
    void question.ask("a", a.request, {rest_ms: 100});
    question.hold();
    expect(questions.settled()).toBe(true);
    await vi.advanceTimersByTimeAsync(200);
    expect(a.request).not.toHaveBeenCalled();
  });
  it("keeps its answer where the next is dropped, and forgets it when it is told to", async () => {
    const a = held<number>();
    question.put("before", 0);
    const answer = question.ask("a", a.request);
    question.drop();
    a.resolve(1);
    expect(await answer).toBeNull();
    expect([question.value, question.busy]).toEqual([0, false]);
    question.forget();
    expect([question.value, question.of]).toEqual([null, null]);
  });
  it("keeps its answer where the request finds that nobody wants it", async () => {
    question.put("before", 0);
    expect(await question.ask("a", () => Promise.resolve(null))).toBeNull();
    expect([question.value, question.of]).toEqual([0, "before"]);
  });
});
