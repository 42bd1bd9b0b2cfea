// Tests that the checks of look.js can fail, with a page on which everything is wrong.

import { spawnSync } from "node:child_process";

const { status, stdout, stderr } = spawnSync("node", ["look/look.js", "look/broken"], { encoding: "utf8" });
const expected = [
    "console: something failed",
    "wider than the screen",
    "axe color-contrast",
    "axe image-alt",
    "the keyboard does not move the figure still",
    "“tiny” is 8.0 pixels high",
    "“one” and “two” overlap",
    "figure moved 9: <circle > is beyond the border",
    "wide: a picture is beyond the figure",
    "printing leaves 1 parts folded",
];
const unseen = expected.filter((what) => !stdout.includes(what));
if (status !== 1 || unseen.length > 0) {
    console.error(`look/look.js does not see: ${unseen.join(", ")}\n${stdout}${stderr}`);
    process.exit(1);
}
