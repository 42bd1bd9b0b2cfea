// The script counts the wrong pixels that the book's own program counts.

import assert from "node:assert/strict";
import { test } from "node:test";

import facts from "../src/facts.json";
import { WAYS, wrong } from "../src/silhouette";

test("a sphere from afar is as wrong here as in the book", () => {
    assert.equal(facts.afar.length, 18);
    for (const { way, far, wrong: expected } of facts.afar) {
        assert.equal(wrong(WAYS[way as keyof typeof WAYS], far), expected, `${way}, ${far}`);
    }
});
