// Around each component test. Setup files are run for every file of tests; what they import is there but once.
import {afterEach, beforeAll, beforeEach} from "vitest";
import {come_to_rest} from "../../src/look/later.svelte";
import {begin_test, end_test} from "./support";

beforeAll(come_to_rest, 600_000); // what a first visit fetches later is there from the start
beforeEach(begin_test);
afterEach(end_test);
