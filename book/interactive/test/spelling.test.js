// The spelling check is shown to fail: a check that finds nothing may not be looking.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { test } from "node:test";

const spelt = (text) =>
    spawnSync("node_modules/.bin/cspell", ["lint", "--config", "cspell.json", "stdin://page.md"], {
        input: text,
        encoding: "utf8",
    });

test("an unknown word is found, and known ones are not", () => {
    const wrong = spelt("The parametre of a ray.\n");
    assert.equal(wrong.status, 1);
    assert.match(wrong.stdout, /Unknown word \(parametre\)/);
    assert.equal(spelt("The colour of a Mitsuba golden, `parametre` and $parametre$.\n").status, 0);
});
